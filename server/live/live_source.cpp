#include "server/live/live_source.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "common/log.h"
#include "common/sources/profile.h"
#include "common/sources/source_reader.h"
#include "server/streams/source_path.h"

namespace aucast::server {
namespace {

/// A recording that is poured in waits in its pipe, not in our memory.
constexpr std::size_t kQueueMost = 256;

}  // namespace

/// One stream of the source.
struct LiveSource::Stream {
  Stream(std::string stream_name, const LiveSourceOptions& options,
         const sources::LiveOptions& reading);

  void take(double moment) {
    for (sources::LiveKeyframe& keyframe : reader.take_keyframes()) {
      queue.push(std::move(keyframe), moment);
    }
  }

  std::string name;
  std::shared_ptr<protocol::LiveFeed> feed;  ///< its sessions hold it too
  sources::LiveReader reader;
  sources::LiveQueue queue;
  LiveThinning thinning;
  std::unique_ptr<Recorder> recorder;
  bool silence_said = true;
};

LiveSource::Stream::Stream(std::string stream_name, const LiveSourceOptions& options,
                           const sources::LiveOptions& reading)
    : name(std::move(stream_name)),
      feed(std::make_shared<protocol::LiveFeed>(reading.keyframe_ms, options.classic_min)),
      reader(sources::name_of(options.path), reading, sources::load_arkit_table),
      thinning(reading.keyframe_ms, options.max_kbits) {}

LiveSource::LiveSource(asio::io_context& io, LiveSourceOptions options, Events events)
    : options_(std::move(options)),
      events_(std::move(events)),
      input_(io, options_.path, options_.follow,
             {[this](std::string_view bytes) { on_bytes(bytes); }, [this] { on_caught_up(); },
              [this] { on_end(); }, [this](const std::string& why) { on_anew(why); }}),
      timer_(io),
      catching_up_(options_.follow) {}

LiveSource::~LiveSource() = default;

Result<void> LiveSource::start() {
  streams_.push_back(
      std::make_unique<Stream>(stream_name(options_.path), options_, options_.reader));
  if (auto opened = input_.start(); !opened) return opened;
  return record(*streams_.front(), options_.record_first);
}

Result<void> LiveSource::record(Stream& stream, bool first) {
  if (options_.record.empty()) return {};
  const auto path = record_path(options_.record, stream.name, first);
  if (!path) return {};
  auto recorder = Recorder::start(*path);
  if (!recorder) return recorder.error();
  stream.recorder = std::move(*recorder);
  return {};
}

Result<void> LiveSource::finish_record() {
  for (const auto& stream : streams_) {
    if (!stream->recorder) continue;
    if (auto recorded = stream->recorder->finish(); !recorded) not_recorded_ = recorded.error();
  }
  if (not_recorded_) return *not_recorded_;
  return {};
}

void LiveSource::stop() {
  stopped_ = true;
  timer_.cancel();
  input_.stop();
}

bool LiveSource::over() const {
  return input_.ended() && std::all_of(streams_.begin(), streams_.end(), [](const auto& stream) {
           return stream->feed->ended() && stream->queue.size() == 0;
         });
}

bool LiveSource::nothing_came() const {
  return input_.ended() && streams_.front()->feed->newest() == nullptr;
}

std::vector<protocol::ServedStream> LiveSource::streams() const {
  std::vector<protocol::ServedStream> served;
  for (const auto& stream : streams_) served.push_back({stream->name, nullptr, stream->feed});
  return served;
}

double LiveSource::now() {
  return seconds(std::chrono::steady_clock::now().time_since_epoch());
}

void LiveSource::on_bytes(std::string_view bytes) {
  if (options_.reader.recording.all_faces) {
    read_line_by_line(bytes);
  } else {
    streams_.front()->reader.feed(bytes, now());
  }
  for (const auto& stream : streams_) stream->take(now());
  if (catching_up_) {
    for (const auto& stream : streams_) stream->queue.skip_to_last(now());
    say();
  } else {
    go_on();
  }
}

/// A face that is new on a line is read from that line on.
void LiveSource::read_line_by_line(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
    const std::string_view line = bytes.substr(0, end);
    for (const auto& stream : streams_) stream->reader.feed(line, now());
    add_faces(line);
    bytes.remove_prefix(end);
  }
}

void LiveSource::add_faces(std::string_view line) {
  sources::LiveReader& first = streams_.front()->reader;
  for (const std::int64_t face : first.take_new_faces()) {
    if (streams_.size() > kFacesMost) {
      spdlog::warn("{}: face {} and what others come get no stream: there are {}",
                   sources::name_of(options_.path), face, kFacesMost);
      return;
    }
    sources::LiveOptions reading = options_.reader;
    reading.recording.all_faces = false;
    reading.recording.face = face;
    const std::string name = face_stream_name(stream_name(options_.path), face);
    streams_.push_back(std::make_unique<Stream>(name, options_, reading));
    Stream& stream = *streams_.back();
    stream.reader.feed(first.header(), now());
    stream.reader.feed(line, now());
    if (auto recorded = record(stream, false); !recorded) {
      not_recorded_ = recorded.error();
      spdlog::error("{}", not_recorded_->message);
    }
    spdlog::info("{}: face {} is the stream {}", sources::name_of(options_.path), face, name);
    events_.on_face();
  }
}

void LiveSource::on_caught_up() {
  if (std::exchange(catching_up_, false)) go_on();
}

void LiveSource::on_anew(const std::string& why) {
  spdlog::info("{}: {}; reading it anew", sources::name_of(options_.path), why);
  for (const auto& stream : streams_) stream->reader.restart();
  catching_up_ = true;
}

void LiveSource::condition(const sources::ConditioningSettings& settings) {
  options_.reader.conditioning = settings;
  for (const auto& stream : streams_) stream->reader.condition(settings);
}

/// Each face has a neutral one of its own; the first stream's is what a profile is made of.
void LiveSource::say_neutral() {
  for (const auto& stream : streams_) {
    const auto neutral = stream->reader.take_neutral();
    if (!neutral) continue;
    const bool first = stream == streams_.front();
    spdlog::info("{}: neutral face {}", first ? sources::name_of(options_.path) : stream->name,
                 sources::measured_text(*neutral));
    if (first && options_.on_neutral) options_.on_neutral(*neutral);
  }
}

void LiveSource::on_end() {
  for (const auto& stream : streams_) stream->reader.end_input(now());
  go_on();
}

/// The readers of single faces would only say the same.
void LiveSource::say() {
  say_neutral();
  for (const auto& stream : streams_) {
    const auto messages = stream->reader.take_messages();
    if (stream != streams_.front()) continue;
    for (const sources::LiveMessage& message : messages) {
      if (message.warning) {
        spdlog::warn("{}", message.text);
      } else {
        spdlog::info("{}", message.text);
      }
    }
  }
}

void LiveSource::go_on() {
  if (stopped_) return;
  say();
  const double moment = now();
  bool hold = false;
  for (const auto& stream : streams_) {
    send_due(*stream, moment);
    hold = hold || stream->queue.size() >= kQueueMost;
    if (stream->queue.size() == 0) rest(*stream, moment);
    send_thinned(*stream, moment);
  }
  input_.hold(hold);
  wait();
}

void LiveSource::send_due(Stream& stream, double moment) {
  if (stream.queue.size() == 0) return;
  if (std::exchange(stream.silence_said, false)) {
    spdlog::info("{}: {}", stream.name,
                 stream.feed->newest() != nullptr ? "goes on" : "the first keyframe is there");
  }
  // Rows of a recogniser with a clock of its own follow each other by that.
  while (const auto keyframe = stream.queue.pop(moment)) {
    send(stream, *keyframe, keyframe->begins || !keyframe->clocked, moment);
  }
  stream.reader.hold_off(moment);
}

/// `free` as RecordTimeline has it. What is kept is not thinned.
void LiveSource::send(Stream& stream, const sources::LiveKeyframe& keyframe, bool free,
                      double moment) {
  if (stream.recorder) stream.recorder->add(keyframe.keyframe, now(), free);
  stream.thinning.push(keyframe.keyframe);
  send_thinned(stream, moment);
}

void LiveSource::send_thinned(Stream& stream, double moment) {
  if (const auto keyframe = stream.thinning.pop(moment)) show(stream, *keyframe);
}

void LiveSource::show(Stream& stream, const protocol::Keyframe& keyframe) {
  stream.feed->add(keyframe);
  events_.on_moment();
}

/// What is due while nothing comes.
void LiveSource::rest(Stream& stream, double moment) {
  stream.reader.idle(moment);
  for (const sources::LiveKeyframe& keyframe : stream.reader.take_keyframes()) {
    send(stream, keyframe, true, moment);
  }
  const bool can_end = options_.timeout.count() > 0 && !stream.feed->ended();
  const auto since = stream.reader.silent_since();
  if (!since) {
    if (!can_end || !nothing_came()) return;
    spdlog::warn("{}: it ended before the first keyframe", sources::name_of(options_.path));
    end(stream);
    return;
  }
  if (moment - *since >= sources::kHoldSeconds && !std::exchange(stream.silence_said, true)) {
    spdlog::info("{}: nothing comes; the face holds, then goes to neutral", stream.name);
  }
  if (!can_end || moment - *since < patience()) return;
  if (input_.ended()) {
    spdlog::info("{}: it has ended, and so has the stream", sources::name_of(options_.path));
  } else {
    spdlog::warn("{}: nothing for {} s: the stream ends for the clients there (--source-timeout)",
                 stream.name, patience());
  }
  end(stream);
}

void LiveSource::end(Stream& stream) {
  if (stream.recorder) stream.recorder->end_of_stream();
  if (const auto last = stream.thinning.take_last()) show(stream, *last);
  stream.feed->end();
  events_.on_moment();
}

/// How long a silence may be. Of what nothing can come any more, only until the face is neutral.
double LiveSource::patience() const {
  const double asked = seconds(options_.timeout);
  return input_.ended() ? std::min(asked, sources::kHoldSeconds + sources::kEaseSeconds) : asked;
}

/// When the next keyframe of its queue is due, or silence brings something.
std::optional<double> LiveSource::next_of(const Stream& stream) const {
  if (const auto due = stream.queue.due()) return due;
  std::optional<double> next = stream.reader.idle_due();
  const auto since = stream.reader.silent_since();
  const auto earlier = [&next](double at) { next = std::min(next.value_or(at), at); };
  if (since && !stream.silence_said) earlier(*since + sources::kHoldSeconds);
  if (since && options_.timeout.count() > 0 && !stream.feed->ended()) {
    earlier(*since + patience());
  }
  return next;
}

void LiveSource::wait() {
  std::optional<double> next;
  const auto earlier = [&next](double at) { next = std::min(next.value_or(at), at); };
  for (const auto& stream : streams_) {
    if (const auto at = next_of(*stream)) earlier(*at);
    if (const auto due = stream->thinning.due()) earlier(*due);
  }
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
