#include "server/live/live_stream.h"

#include <algorithm>
#include <utility>

#include "common/earlier.h"
#include "common/log.h"
#include "common/sources/hold.h"
#include "common/sources/source_reader.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

/// The longest queue: a recording that is fed in at once waits in its pipe, not in our memory.
constexpr std::size_t kQueueMax = 256;

}  // namespace

LiveStream::LiveStream(std::string name, const LiveStreamOptions& options,
                       const sources::LiveOptions& reading, bool with_voice,
                       std::function<void()> on_moment)
    : name_(std::move(name)),
      options_(options),
      on_moment_(std::move(on_moment)),
      feed_(std::make_shared<protocol::LiveFeed>(reading.keyframe_ms, options.classic_min,
                                                 with_voice)),
      reader_(sources::name_of(options.path), reading, sources::load_arkit_table),
      thinning_(reading.keyframe_ms,
                with_voice ? options.link : LinkLimits{options.link.kbits, options.link.batch}),
      silence_(options.timeout) {
  if (with_voice) voice_.emplace(options.encoder, options.voice_delay);
}

Result<void> LiveStream::record(const std::filesystem::path& path) {
  auto recorder = Recorder::start(path);
  if (!recorder) return recorder.error();
  recorder_ = std::move(*recorder);
  if (voice_) return recorder_->add_voice_file();
  return {};
}

Result<void> LiveStream::finish_record() {
  return recorder_ ? recorder_->finish() : Result<void>();
}

void LiveStream::take(SteadyTime now, bool only_last) {
  for (sources::LiveKeyframe& keyframe : reader_.take_keyframes()) {
    queue_.push(std::move(keyframe), now);
  }
  if (only_last) queue_.skip_to_last(now);
}

void LiveStream::feed_voice(std::string_view bytes, SteadyTime now) {
  send_voice(voice_->add(bytes, now), now);
}

void LiveStream::end_voice(SteadyTime now) {
  spdlog::info("{}: the voice has ended", name_);
  send_voice(voice_->end_sound(), now);
}

void LiveStream::send_voice(std::vector<protocol::VoicePacket> packets, SteadyTime now) {
  if (packets.empty() || feed_->ended()) return;
  voice_at_ = now;
  for (protocol::VoicePacket& packet : packets) {
    protocol::EncodedVoice encoded(packet);
    thinning_.spend(encoded.continued.size(), now);
    feed_->add_voice(std::move(encoded));
    const Milliseconds after = packet.place - end_;
    if (recorder_) recorder_->add_voice(std::move(packet), after);
  }
  on_moment_();
}

void LiveStream::end_input(SteadyTime now, bool for_good) {
  silence_.set_final(for_good);
  reader_.end_input(now);
}

void LiveStream::go_on(SteadyTime now) {
  send_due(now);
  if (queue_.size() == 0) rest(now);
  send_thinned(now);
}

bool LiveStream::full() const {
  return queue_.size() >= kQueueMax;
}

void LiveStream::send_due(SteadyTime now) {
  if (queue_.size() == 0) return;
  if (silence_.broken()) {
    spdlog::info("{}: {}", name_, begun() ? "goes on" : "the first keyframe is there");
  }
  // Rows of a recogniser with a clock of its own follow each other by that.
  while (const auto keyframe = queue_.pop(now)) {
    send(*keyframe, keyframe->begins || !keyframe->clocked, now);
  }
  reader_.hold_off(now);
}

/// Passes on a keyframe and, before it, the face that was held until then.
void LiveStream::send(const sources::LiveKeyframe& keyframe, bool free, SteadyTime now) {
  if (voice_ && free) {
    // A keyframe's own time is part of what has passed.
    fill_pause(now - Milliseconds(keyframe.keyframe.time_ms.value_or(0)));
  }
  pass(keyframe.keyframe, free, now);
}

void LiveStream::fill_pause(SteadyTime now) {
  if (!clock_begin_) return;
  const Milliseconds pause = std::chrono::round<Milliseconds>(now - *clock_begin_) - end_;
  for (const protocol::Keyframe& held : sources::held_face(shown_, pause)) pass(held, true, now);
}

/// The record is not thinned.
void LiveStream::pass(const protocol::Keyframe& keyframe, bool free, SteadyTime now) {
  end_ += Milliseconds(keyframe.time_ms.value_or(0));
  if (voice_) {
    if (!clock_begin_) clock_begin_ = now - end_;
    voice_->add_keyframe(end_, now);
    shown_ = keyframe.terms;
  }
  if (recorder_) recorder_->add(keyframe, now, free);
  thinning_.push(keyframe);
  send_thinned(now);
}

void LiveStream::send_thinned(SteadyTime now) {
  if (const auto keyframe = thinning_.pop(now)) show(*keyframe);
}

void LiveStream::show(const protocol::Keyframe& keyframe) {
  feed_->add(keyframe);
  on_moment_();
}

/// Does what is due while nothing comes.
void LiveStream::rest(SteadyTime now) {
  ease(now);
  if (voice_ && !feed_->ended() && now >= beat()) fill_pause(now);
  if (const auto since = silent_since()) {
    if (silence_.to_be_said(*since, now)) {
      spdlog::info("{}: nothing comes; the face holds, then goes to neutral", name_);
    }
    if (!feed_->ended() && silence_.is_over(*since, now)) end_by_silence();
  } else if (!feed_->ended() && silence_.ends() && silence_.is_final() && !begun()) {
    spdlog::warn("{}: it ended before the first keyframe", sources::name_of(options_.path));
    end();
  }
}

/// The face goes to neutral when it was held long enough.
void LiveStream::ease(SteadyTime now) {
  reader_.idle(now);
  const auto easing = reader_.take_keyframes();
  if (feed_->ended()) return;  // nobody sees it
  for (const sources::LiveKeyframe& keyframe : easing) send(keyframe, true, now);
}

void LiveStream::end_by_silence() {
  if (silence_.is_final()) {
    spdlog::info("{}: it has ended, and so has the stream", sources::name_of(options_.path));
  } else {
    spdlog::warn("{}: nothing for {} s: the stream ends for the clients there (--source-timeout)",
                 name_, seconds(silence_.patience()));
  }
  end();
}

void LiveStream::end() {
  if (recorder_) recorder_->end_of_stream();
  if (const auto last = thinning_.take_last()) show(*last);
  feed_->end();
  clock_begin_.reset();
  if (voice_) voice_->end_face();
  on_moment_();
}

/// Since when neither face nor voice has come. Once the face's input has ended for good, the voice
/// does not count.
std::optional<SteadyTime> LiveStream::silent_since() const {
  const auto since = reader_.silent_since();
  if (!since || !voice_ || silence_.is_final()) return since;
  return std::max(*since, voice_at_);
}

/// With a voice: when to send the held face again, so that the clock goes on.
SteadyTime LiveStream::beat() const {
  /// From the end of the last keyframe; by then the face is no longer held (kHoldSeconds).
  constexpr Seconds kBeat(sources::kHoldSeconds + 0.25);
  return clock_begin_.value_or(SteadyTime()) + end_ + kBeat;
}

std::optional<SteadyTime> LiveStream::next() const {
  std::optional<SteadyTime> next = thinning_.due();
  if (const auto due = queue_.due()) return earlier(next, due);
  next = earlier(next, reader_.idle_due());
  if (const auto since = silent_since()) {
    next = earlier(next, silence_.next(*since, feed_->ended()));
  }
  if (clock_begin_) next = earlier(next, std::optional(beat()));
  return next;
}

}  // namespace aucast::server
