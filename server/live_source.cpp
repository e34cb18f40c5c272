#include "server/live_source.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "common/log.h"
#include "server/source_reader.h"

namespace aucast::server {
namespace {

/// A recording that is poured in waits in its pipe, not in our memory.
constexpr std::size_t kQueueMost = 256;

double seconds(Milliseconds time) {
  return static_cast<double>(time.count()) / 1000;
}

std::string file_name(const std::filesystem::path& path) {
  return path == "-" ? "stdin" : path.string();
}

}  // namespace

std::string stream_name(const std::filesystem::path& path) {
  return path == "-" ? "live" : path.stem().string();
}

bool is_live(const std::filesystem::path& path, bool follow) {
  if (path == "-") return true;
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_regular_file(status)) return follow;
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status);
}

LiveSource::LiveSource(asio::io_context& io, LiveSourceOptions options, OnMoment on_moment)
    : options_(std::move(options)),
      on_moment_(std::move(on_moment)),
      feed_(options_.reader.keyframe_ms, options_.classic_min),
      reader_(file_name(options_.path), options_.reader, load_arkit_table),
      thinning_(options_.reader.keyframe_ms, options_.max_kbits),
      input_(io, options_.path, options_.follow,
             {[this](std::string_view bytes) { on_bytes(bytes); }, [this] { on_caught_up(); },
              [this] {
                reader_.end_input(now());
                go_on();
              },
              [this](const std::string& why) { on_anew(why); }}),
      timer_(io),
      catching_up_(options_.follow) {}

Result<void> LiveSource::start() {
  if (auto opened = input_.start(); !opened || options_.record.empty()) return opened;
  auto recorder = Recorder::start(options_.record);
  if (!recorder) return recorder.error();
  recorder_ = std::move(*recorder);
  return {};
}

Result<void> LiveSource::finish_record() {
  if (!recorder_) return {};
  return recorder_->finish();
}

void LiveSource::stop() {
  stopped_ = true;
  timer_.cancel();
  input_.stop();
}

double LiveSource::now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void LiveSource::on_bytes(std::string_view bytes) {
  reader_.feed(bytes, now());
  take();
  if (catching_up_) {
    queue_.skip_to_last(now());
    say();
  } else {
    go_on();
  }
}

void LiveSource::on_caught_up() {
  if (std::exchange(catching_up_, false)) go_on();
}

void LiveSource::on_anew(const std::string& why) {
  spdlog::info("{}: {}; reading it anew", file_name(options_.path), why);
  reader_.restart();
  catching_up_ = true;
}

void LiveSource::take() {
  for (sources::LiveKeyframe& keyframe : reader_.take_keyframes()) {
    queue_.push(std::move(keyframe), now());
  }
}

void LiveSource::say() {
  for (const sources::LiveMessage& message : reader_.take_messages()) {
    if (message.warning) {
      spdlog::warn("{}", message.text);
    } else {
      spdlog::info("{}", message.text);
    }
  }
}

void LiveSource::go_on() {
  if (stopped_) return;
  say();
  const double moment = now();
  send_due(moment);
  input_.hold(queue_.size() >= kQueueMost);
  if (queue_.size() == 0) rest(moment);
  send_thinned(moment);
  wait();
}

void LiveSource::send_due(double moment) {
  if (queue_.size() == 0) return;
  if (std::exchange(silence_said_, false)) {
    spdlog::info("{}: {}", file_name(options_.path),
                 feed_.newest() ? "goes on" : "the first keyframe is there");
  }
  // Rows of a recogniser with a clock of its own follow each other by that.
  while (const auto keyframe = queue_.pop(moment)) {
    send(*keyframe, keyframe->begins || !keyframe->clocked, moment);
  }
  reader_.hold_off(moment);
}

/// `free` as RecordTimeline has it. What is kept is not thinned.
void LiveSource::send(const sources::LiveKeyframe& keyframe, bool free, double moment) {
  if (recorder_) recorder_->add(keyframe.keyframe, now(), free);
  thinning_.push(keyframe.keyframe);
  send_thinned(moment);
}

void LiveSource::send_thinned(double moment) {
  if (const auto keyframe = thinning_.pop(moment)) show(*keyframe);
}

void LiveSource::show(const protocol::Keyframe& keyframe) {
  feed_.add(keyframe);
  on_moment_();
}

/// What is due while nothing comes.
void LiveSource::rest(double moment) {
  reader_.idle(moment);
  for (const sources::LiveKeyframe& keyframe : reader_.take_keyframes()) {
    send(keyframe, true, moment);
  }
  if (nothing_came() && options_.timeout.count() > 0 && !feed_.ended()) {
    spdlog::warn("{}: it ended before the first keyframe", file_name(options_.path));
    feed_.end();
    on_moment_();
  }
  const auto since = reader_.silent_since();
  if (!since) return;
  if (moment - *since >= sources::kHoldSeconds && !std::exchange(silence_said_, true)) {
    spdlog::info("{}: nothing comes; the face holds, then goes to neutral",
                 file_name(options_.path));
  }
  if (options_.timeout.count() == 0 || moment - *since < patience() || feed_.ended()) return;
  if (input_.ended()) {
    spdlog::info("{}: it has ended, and so has the stream", file_name(options_.path));
  } else {
    spdlog::warn("{}: nothing for {} s: the stream ends for the clients there (--source-timeout)",
                 file_name(options_.path), patience());
  }
  if (recorder_) recorder_->end_of_stream();
  if (const auto last = thinning_.take_last()) show(*last);
  feed_.end();
  on_moment_();
}

/// How long a silence may be. Of what nothing can come any more, only until the face is neutral.
double LiveSource::patience() const {
  const double asked = seconds(options_.timeout);
  return input_.ended() ? std::min(asked, sources::kHoldSeconds + sources::kEaseSeconds) : asked;
}

/// Until the next keyframe in the queue, or until silence brings something.
void LiveSource::wait() {
  std::optional<double> next = queue_.due();
  if (!next) {
    next = reader_.idle_due();
    const auto since = reader_.silent_since();
    const auto earlier = [&next](double at) { next = std::min(next.value_or(at), at); };
    if (since && !silence_said_) earlier(*since + sources::kHoldSeconds);
    if (since && options_.timeout.count() > 0 && !feed_.ended()) {
      earlier(*since + patience());
    }
  }
  if (const auto due = thinning_.due()) next = std::min(next.value_or(*due), *due);
  if (!next) {
    timer_.cancel();
    return;
  }
  timer_.expires_after(std::chrono::duration_cast<Duration>(
      std::chrono::duration<double>(std::max(*next - now(), 0.0))));
  timer_.async_wait([this](const std::error_code& error) {
    if (!error) go_on();
  });
}

}  // namespace aucast::server
