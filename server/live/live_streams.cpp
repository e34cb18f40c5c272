#include "server/live/live_streams.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "common/log.h"
#include "common/sources/profile.h"
#include "common/sources/source_reader.h"
#include "protocol/limits.h"
#include "server/live/steady_seconds.h"
#include "server/streams/film_source.h"
#include "server/streams/source_path.h"

namespace aucast::server {
namespace {

/// A recording that is poured in waits in its pipe, not in our memory.
constexpr std::size_t kQueueMax = 256;

}  // namespace

/// One stream of the source.
struct LiveStreams::Stream {
  Stream(std::string stream_name, const LiveSourceOptions& options,
         const sources::LiveOptions& reading, bool with_voice);

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
  Milliseconds end{0};  ///< of the last keyframe that was made, on the feed's clock

  // With a voice only.
  std::optional<LiveVoice> voice;
  std::optional<double> clock_begin;  ///< when the feed's clock was 0 last; nothing: it stands
  double voice_at = 0;                ///< when there was any last
  std::vector<AuTerm> shown;
};

LiveStreams::Stream::Stream(std::string stream_name, const LiveSourceOptions& options,
                            const sources::LiveOptions& reading, bool with_voice)
    : name(std::move(stream_name)),
      feed(std::make_shared<protocol::LiveFeed>(reading.keyframe_ms, options.classic_min,
                                                with_voice)),
      reader(sources::name_of(options.path), reading, sources::load_arkit_table),
      thinning(reading.keyframe_ms,
               with_voice ? options.link : LinkLimits{options.link.kbits, options.link.batch}) {
  if (with_voice) voice.emplace(options.encoder, options.voice_delay);
}

LiveStreams::LiveStreams(LiveSourceOptions options, Events events)
    : options_(std::move(options)), events_(std::move(events)), catching_up_(options_.follow) {
  streams_.push_back(std::make_unique<Stream>(stream_name(options_.path), options_, options_.reader,
                                              !options_.voice.empty()));
}

LiveStreams::~LiveStreams() = default;

Result<void> LiveStreams::start() {
  return record(*streams_.front(), options_.record_first);
}

Result<void> LiveStreams::record(Stream& stream, bool first) {
  if (options_.record.empty()) return {};
  const auto path = record_path(options_.record, stream.name, first);
  if (!path) return {};
  auto recorder = Recorder::start(*path);
  if (!recorder) return recorder.error();
  stream.recorder = std::move(*recorder);
  if (stream.voice) return stream.recorder->add_voice_file();
  return {};
}

Result<void> LiveStreams::finish_record() {
  for (const auto& stream : streams_) {
    if (!stream->recorder) continue;
    auto recorded = stream->recorder->finish();
    if (!recorded && !not_recorded_) not_recorded_ = recorded.error();
  }
  if (not_recorded_) return *not_recorded_;
  return {};
}

bool LiveStreams::over() const {
  return ended_ && std::all_of(streams_.begin(), streams_.end(), [](const auto& stream) {
           return stream->feed->ended() && stream->queue.size() == 0;
         });
}

bool LiveStreams::nothing_came() const {
  return ended_ && streams_.front()->feed->newest() == nullptr;
}

std::vector<protocol::ServedStream> LiveStreams::served() const {
  std::vector<protocol::ServedStream> served;
  for (const auto& stream : streams_) served.push_back({stream->name, nullptr, stream->feed});
  return served;
}

void LiveStreams::feed(std::string_view bytes, Instant at) {
  const double now = steady_seconds(at);
  if (options_.reader.recording.all_faces) {
    read_line_by_line(bytes, now);
  } else {
    streams_.front()->reader.feed(bytes, now);
  }
  for (const auto& stream : streams_) stream->take(now);
  if (catching_up_) {
    for (const auto& stream : streams_) stream->queue.skip_to_last(now);
    say();
  } else {
    go_on(now);
  }
}

/// A face that is new on a line is read from that line on.
void LiveStreams::read_line_by_line(std::string_view bytes, double now) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
    const std::string_view line = bytes.substr(0, end);
    for (const auto& stream : streams_) stream->reader.feed(line, now);
    add_faces(line, now);
    bytes.remove_prefix(end);
  }
}

void LiveStreams::add_faces(std::string_view line, double now) {
  sources::LiveReader& first = streams_.front()->reader;
  for (const std::int64_t face : first.take_new_faces()) {
    if (streams_.size() > kFacesMax) {
      if (std::exchange(more_faces_said_, true)) return;
      spdlog::warn("{}: face {} and what others come get no stream: there are {}",
                   sources::name_of(options_.path), face, kFacesMax);
      return;
    }
    sources::LiveOptions reading = options_.reader;
    reading.recording.all_faces = false;
    reading.recording.face = face;
    const std::string name = face_stream_name(stream_name(options_.path), face);
    streams_.push_back(std::make_unique<Stream>(name, options_, reading, false));
    Stream& stream = *streams_.back();
    stream.reader.feed(first.header(), now);
    stream.reader.feed(line, now);
    if (auto recorded = record(stream, false); !recorded) {
      not_recorded_ = recorded.error();
      spdlog::error("{}", not_recorded_->message);
    }
    spdlog::info("{}: face {} is the stream {}", sources::name_of(options_.path), face, name);
    events_.on_face();
  }
}

void LiveStreams::feed_voice(std::string_view bytes, Instant at) {
  const double now = steady_seconds(at);
  send_voice(streams_.front()->voice->add(bytes, now), now);
}

void LiveStreams::send_voice(std::vector<protocol::VoicePacket> packets, double now) {
  Stream& stream = *streams_.front();
  if (packets.empty() || stream.feed->ended()) return;
  stream.voice_at = now;
  for (protocol::VoicePacket& packet : packets) {
    protocol::EncodedVoice encoded(packet);
    stream.thinning.spend(encoded.continued.size(), now);
    stream.feed->add_voice(std::move(encoded));
    const Milliseconds after = packet.place - stream.end;
    if (stream.recorder) stream.recorder->add_voice(std::move(packet), after);
  }
  events_.on_moment();
}

void LiveStreams::end_voice(Instant at) {
  spdlog::info("{}: the voice has ended", streams_.front()->name);
  send_voice(streams_.front()->voice->end_sound(), steady_seconds(at));
}

void LiveStreams::caught_up(Instant now) {
  if (std::exchange(catching_up_, false)) go_on(steady_seconds(now));
}

void LiveStreams::begin_anew(const std::string& why) {
  spdlog::info("{}: {}; reading it anew", sources::name_of(options_.path), why);
  for (const auto& stream : streams_) stream->reader.restart();
  catching_up_ = true;
}

void LiveStreams::condition(const sources::ConditioningSettings& settings) {
  options_.reader.conditioning = conditioning_for(options_.path, settings);
  for (const auto& stream : streams_) stream->reader.condition(options_.reader.conditioning);
}

/// Each face has a neutral one of its own; the first stream's is what a profile is made of.
void LiveStreams::say_neutral() {
  for (const auto& stream : streams_) {
    const auto neutral = stream->reader.take_neutral();
    if (!neutral) continue;
    const bool first = stream == streams_.front();
    spdlog::info("{}: neutral face {}", first ? sources::name_of(options_.path) : stream->name,
                 sources::measured_text(*neutral));
    if (first && options_.on_neutral) options_.on_neutral(*neutral);
  }
}

void LiveStreams::end_input(Instant now, bool for_good) {
  ended_ = for_good;
  for (const auto& stream : streams_) stream->reader.end_input(steady_seconds(now));
  go_on(steady_seconds(now));
}

/// While a followed file is caught up with, nothing of it is due yet.
void LiveStreams::advance(Instant now) {
  if (!catching_up_) go_on(steady_seconds(now));
}

/// The readers of single faces would only say the same.
void LiveStreams::say() {
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

void LiveStreams::go_on(double now) {
  say();
  for (const auto& stream : streams_) {
    send_due(*stream, now);
    if (stream->queue.size() == 0) rest(*stream, now);
    send_thinned(*stream, now);
  }
}

bool LiveStreams::full() const {
  return std::any_of(streams_.begin(), streams_.end(),
                     [](const auto& stream) { return stream->queue.size() >= kQueueMax; });
}

void LiveStreams::send_due(Stream& stream, double now) {
  if (stream.queue.size() == 0) return;
  if (std::exchange(stream.silence_said, false)) {
    spdlog::info("{}: {}", stream.name,
                 stream.feed->newest() != nullptr ? "goes on" : "the first keyframe is there");
  }
  // Rows of a recogniser with a clock of its own follow each other by that.
  while (const auto keyframe = stream.queue.pop(now)) {
    send(stream, *keyframe, keyframe->begins || !keyframe->clocked, now);
  }
  stream.reader.hold_off(now);
}

/// `free` as RecordTimeline has it.
void LiveStreams::send(Stream& stream, const sources::LiveKeyframe& keyframe, bool free,
                       double now) {
  if (stream.voice && free) {
    // A keyframe's own time is part of what has passed.
    fill_pause(stream, now - keyframe.keyframe.duration_ms.value_or(0) / 1000.0);
  }
  pass(stream, keyframe.keyframe, free, now);
}

/// With a voice: the face that stood since the last keyframe, with the time that it stood.
void LiveStreams::fill_pause(Stream& stream, double now) {
  /// Processes wait for each other so long.
  constexpr Milliseconds kPauseLeast{100};
  if (!stream.clock_begin) return;
  const double passed = (now - *stream.clock_begin) * 1000;
  const Milliseconds pause = Milliseconds(std::llround(passed)) - stream.end;
  if (pause < kPauseLeast) return;
  protocol::Keyframe held;
  held.terms = stream.shown;
  held.duration_ms = static_cast<std::uint32_t>(
      std::min<Milliseconds::rep>(pause.count(), protocol::kDurationMsMax));
  pass(stream, held, true, now);
}

/// What is kept is not thinned.
void LiveStreams::pass(Stream& stream, const protocol::Keyframe& keyframe, bool free, double now) {
  stream.end += Milliseconds(keyframe.duration_ms.value_or(0));
  if (stream.voice) {
    if (!stream.clock_begin) stream.clock_begin = now - seconds(stream.end);
    stream.voice->add_keyframe(stream.end, now);
    stream.shown = keyframe.terms;
  }
  if (stream.recorder) stream.recorder->add(keyframe, now, free);
  stream.thinning.push(keyframe);
  send_thinned(stream, now);
}

void LiveStreams::send_thinned(Stream& stream, double now) {
  if (const auto keyframe = stream.thinning.pop(now)) show(stream, *keyframe);
}

void LiveStreams::show(Stream& stream, const protocol::Keyframe& keyframe) {
  stream.feed->add(keyframe);
  events_.on_moment();
}

/// What is due while nothing comes.
void LiveStreams::rest(Stream& stream, double now) {
  stream.reader.idle(now);
  for (const sources::LiveKeyframe& keyframe : stream.reader.take_keyframes()) {
    send(stream, keyframe, true, now);
  }
  if (stream.voice && !stream.feed->ended() && now >= beat_of(stream)) fill_pause(stream, now);
  const bool can_end = options_.timeout.count() > 0 && !stream.feed->ended();
  const auto since = silent_since(stream);
  if (!since) {
    if (!can_end || !nothing_came()) return;
    spdlog::warn("{}: it ended before the first keyframe", sources::name_of(options_.path));
    end(stream);
    return;
  }
  if (now - *since >= sources::kHoldSeconds && !std::exchange(stream.silence_said, true)) {
    spdlog::info("{}: nothing comes; the face holds, then goes to neutral", stream.name);
  }
  if (!can_end || now - *since < patience()) return;
  if (ended_) {
    spdlog::info("{}: it has ended, and so has the stream", sources::name_of(options_.path));
  } else {
    spdlog::warn("{}: nothing for {} s: the stream ends for the clients there (--source-timeout)",
                 stream.name, patience());
  }
  end(stream);
}

void LiveStreams::end(Stream& stream) {
  if (stream.recorder) stream.recorder->end_of_stream();
  if (const auto last = stream.thinning.take_last()) show(stream, *last);
  stream.feed->end();
  stream.clock_begin.reset();
  if (stream.voice) stream.voice->end_face();
  events_.on_moment();
}

/// Since when neither face nor voice has come. Of what can come no more the voice does not count.
std::optional<double> LiveStreams::silent_since(const Stream& stream) const {
  const auto since = stream.reader.silent_since();
  if (!since || !stream.voice || ended_) return since;
  return std::max(*since, stream.voice_at);
}

/// With a voice: when the face that stands is sent again, so that the clock goes on.
double LiveStreams::beat_of(const Stream& stream) {
  /// The last keyframe is over for so long: the face has been given up by then (kHoldSeconds).
  constexpr double kBeatSeconds = sources::kHoldSeconds + 0.25;
  return stream.clock_begin.value_or(0) + seconds(stream.end) + kBeatSeconds;
}

/// How long a silence may be. Of what nothing can come any more, only until the face is neutral.
double LiveStreams::patience() const {
  const double asked = seconds(options_.timeout);
  return ended_ ? std::min(asked, sources::kHoldSeconds + sources::kEaseSeconds) : asked;
}

/// When the next keyframe of its queue is due, or silence brings something.
std::optional<double> LiveStreams::next_of(const Stream& stream) const {
  if (const auto due = stream.queue.due()) return due;
  std::optional<double> next = stream.reader.idle_due();
  const auto since = silent_since(stream);
  const auto earlier = [&next](double at) { next = std::min(next.value_or(at), at); };
  if (since && !stream.silence_said) earlier(*since + sources::kHoldSeconds);
  if (since && options_.timeout.count() > 0 && !stream.feed->ended()) {
    earlier(*since + patience());
  }
  if (stream.clock_begin) earlier(beat_of(stream));
  return next;
}

std::optional<Instant> LiveStreams::next() const {
  if (catching_up_) return std::nullopt;
  std::optional<double> next;
  const auto earlier = [&next](double at) { next = std::min(next.value_or(at), at); };
  for (const auto& stream : streams_) {
    if (const auto at = next_of(*stream)) earlier(*at);
    if (const auto due = stream->thinning.due()) earlier(*due);
  }
  if (!next) return std::nullopt;
  return just_after(*next);
}

}  // namespace aucast::server
