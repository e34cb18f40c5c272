#include "server/live/live_streams.h"

#include <algorithm>
#include <utility>

#include "common/earlier.h"
#include "common/log.h"
#include "common/sources/loud_aus.h"
#include "common/sources/profile.h"
#include "common/sources/source_reader.h"
#include "server/streams/film_source.h"
#include "server/streams/source_path.h"

namespace aucast::server {

LiveStreams::LiveStreams(LiveStreamsOptions options, Events events)
    : options_(std::move(options)), events_(std::move(events)), catching_up_(options_.follow) {
  add(stream_name(options_.each.path), options_.each.reader, options_.each.voice);
}

void LiveStreams::add(std::string name, const sources::LiveOptions& reading, bool with_voice) {
  streams_.push_back(std::make_unique<LiveStream>(std::move(name), options_.each, reading,
                                                  with_voice, events_.on_moment));
}

Result<void> LiveStreams::start() {
  return record(first(), options_.record_first);
}

Result<void> LiveStreams::record(LiveStream& stream, bool first) {
  if (options_.record.empty()) return {};
  const auto path = record_path(options_.record, stream.name(), first);
  return path ? stream.record(*path) : Result<void>();
}

Result<void> LiveStreams::finish_record() {
  for (const auto& stream : streams_) {
    auto recorded = stream->finish_record();
    if (!recorded && !not_recorded_) not_recorded_ = recorded.error();
  }
  if (not_recorded_) return *not_recorded_;
  return {};
}

bool LiveStreams::over() const {
  return ended_ && std::all_of(streams_.begin(), streams_.end(),
                               [](const auto& stream) { return stream->ended(); });
}

std::vector<protocol::ServedStream> LiveStreams::served() const {
  std::vector<protocol::ServedStream> served;
  for (const auto& stream : streams_) served.push_back(stream->served());
  return served;
}

void LiveStreams::feed(std::string_view bytes, Instant now) {
  if (options_.each.reader.recording.all_faces) {
    read_line_by_line(bytes, now);
  } else {
    first().reader().feed(bytes, now);
  }
  for (const auto& stream : streams_) stream->take(now, catching_up_);
  if (catching_up_) {
    say();
  } else {
    go_on(now);
  }
}

/// Feeds the readers line by line, so that a new face is read from the line on which it is first
/// seen.
void LiveStreams::read_line_by_line(std::string_view bytes, SteadyTime now) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size() - 1) + 1;
    const std::string_view line = bytes.substr(0, end);
    for (const auto& stream : streams_) stream->reader().feed(line, now);
    add_faces(now);
    bytes.remove_prefix(end);
  }
}

void LiveStreams::add_faces(SteadyTime now) {
  const std::filesystem::path& path = options_.each.path;
  for (const auto& [face, beginning] : first().reader().take_new_faces()) {
    if (streams_.size() > kFaceStreamsMax) {
      if (std::exchange(more_faces_said_, true)) return;
      spdlog::warn("{}: face {} and what others come get no stream: there are {}",
                   sources::name_of(path), face, kFaceStreamsMax);
      return;
    }
    const std::string name = face_stream_name(stream_name(path), face);
    if (options_.take_name && !options_.take_name(name)) {
      spdlog::warn("{}: face {} gets no stream: another one here is called {}",
                   sources::name_of(path), face, name);
      continue;
    }
    sources::LiveOptions reading = options_.each.reader;
    reading.recording.all_faces = false;
    reading.recording.face = face;
    add(name, reading, false);
    LiveStream& stream = *streams_.back();
    stream.reader().feed(beginning, now);
    if (auto recorded = record(stream, false); !recorded) {
      not_recorded_ = recorded.error();
      spdlog::error("{}", not_recorded_->message);
    }
    spdlog::info("{}: face {} is the stream {}", sources::name_of(path), face, name);
    events_.on_face();
  }
}

void LiveStreams::feed_voice(std::string_view bytes, Instant now) {
  first().feed_voice(bytes, now);
}

void LiveStreams::end_voice(Instant now) {
  first().end_voice(now);
}

void LiveStreams::caught_up(Instant now) {
  if (std::exchange(catching_up_, false)) go_on(now);
}

void LiveStreams::begin_anew(const std::string& why) {
  spdlog::info("{}: {}; reading it anew", sources::name_of(options_.each.path), why);
  for (const auto& stream : streams_) stream->reader().restart();
  catching_up_ = true;
}

void LiveStreams::condition(const sources::ConditioningSettings& settings) {
  sources::ConditioningSettings& ours = options_.each.reader.conditioning;
  ours = conditioning_for(options_.each.path, settings);
  for (const auto& stream : streams_) stream->reader().condition(ours);
}

/// As of a recording, whose other first seconds can be looked at, too.
void LiveStreams::warn_unless_neutral(const std::string& name,
                                      const sources::MeasuredNeutral& neutral) const {
  if (options_.each.reader.conditioning.neutral_turns_only) return;
  const auto loud = sources::loud_aus(neutral);
  if (loud.empty()) return;
  spdlog::warn("{}: {}; start again with a neutral face, or leave out --neutral", name,
               sources::not_neutral_text(loud));
}

/// Each face has a neutral one of its own; the first stream's is what a profile is made of.
void LiveStreams::say_neutral() {
  for (const auto& stream : streams_) {
    const auto neutral = stream->reader().take_neutral();
    if (!neutral) continue;
    const bool is_first = stream == streams_.front();
    const std::string name = is_first ? sources::name_of(options_.each.path) : stream->name();
    spdlog::info("{}: neutral face {}", name, sources::measured_text(*neutral));
    warn_unless_neutral(name, *neutral);
    if (is_first) events_.on_neutral(*neutral);
  }
}

void LiveStreams::end_input(Instant now, bool for_good) {
  ended_ = for_good;
  for (const auto& stream : streams_) stream->end_input(now, for_good);
  go_on(now);
}

/// While catching up with a followed file, nothing is due yet.
void LiveStreams::advance(Instant now) {
  if (!catching_up_) go_on(now);
}

/// Logs messages of the first stream's reader; those of further faces would only repeat them.
void LiveStreams::say() {
  say_neutral();
  for (const auto& stream : streams_) {
    const auto messages = stream->reader().take_messages();
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

void LiveStreams::go_on(SteadyTime now) {
  say();
  for (const auto& stream : streams_) stream->go_on(now);
}

bool LiveStreams::full() const {
  return std::any_of(streams_.begin(), streams_.end(),
                     [](const auto& stream) { return stream->full(); });
}

std::optional<Instant> LiveStreams::next() const {
  if (catching_up_) return std::nullopt;
  std::optional<SteadyTime> next;
  for (const auto& stream : streams_) {
    next = earlier(next, stream->next());
  }
  if (!next) return std::nullopt;
  return just_after(*next);
}

}  // namespace aucast::server
