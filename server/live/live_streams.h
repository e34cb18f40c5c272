#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "protocol/server_session.h"
#include "server/live/live_stream.h"

namespace aucast::server {

struct LiveStreamsOptions {
  LiveStreamOptions each;
  bool follow = false;           ///< what the source holds already is past
  std::filesystem::path record;  ///< what --record says; empty: nothing is kept
  bool record_first = true;      ///< this source is the one that a file is for
};

/// The streams of one source that is being written. What a followed file already holds is past:
/// only its last row is sent.
///
/// The first stream is there from the beginning, and a voice belongs to it; with --face-id all each
/// face that is seen gets another one, read from the same bytes by its own reader.
///
/// Knows no file except its records, and no clock: every call also sends what is due, and next()
/// tells when advance() has to be called.
/// Thread: none of its own.
class LiveStreams {
 public:
  /// More faces than this get no stream.
  static constexpr std::size_t kFaceStreamsMax = 16;

  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new
    /// A face is seen for the first time; its stream is the last of served().
    std::function<void()> on_face;
    /// The neutral face of the first stream was asked for and has been measured.
    std::function<void(const sources::MeasuredNeutral&)> on_neutral =
        [](const sources::MeasuredNeutral&) {};
  };

  LiveStreams(LiveStreamsOptions options, Events events);
  LiveStreams(const LiveStreams&) = delete;
  LiveStreams& operator=(const LiveStreams&) = delete;

  /// Opens the record, if there is one to be. Fails as Recorder::start().
  [[nodiscard]] Result<void> start();

  void feed(std::string_view bytes, Instant now);
  /// All that a followed file holds has been fed.
  void caught_up(Instant now);
  /// The file is read from its beginning again, for this reason.
  void begin_anew(const std::string& why);
  /// Whoever wrote has gone. `for_good`: nobody can write any more.
  void end_input(Instant now, bool for_good);
  /// Raw sound, as LiveVoice takes it.
  void feed_voice(std::string_view bytes, Instant now);
  /// Whoever wrote the sound has gone.
  void end_voice(Instant now);
  /// Sends what is due, or what silence brings.
  void advance(Instant now);
  /// When advance() has something to do; nothing: not before something is fed.
  [[nodiscard]] std::optional<Instant> next() const;
  /// So much waits for its time that nothing should be fed for now.
  [[nodiscard]] bool full() const;

  /// What kept it from being recorded whole. Waits until the records are written.
  [[nodiscard]] Result<void> finish_record();
  /// Nothing can come any more, and everybody was told so.
  [[nodiscard]] bool over() const;
  /// It has ended before the first keyframe.
  [[nodiscard]] bool nothing_came() const { return ended_ && !first().begun(); }
  /// The streams in the form in which they are served, the first one first.
  [[nodiscard]] std::vector<protocol::ServedStream> served() const;
  /// Other settings of the signals from the next row on.
  void condition(const sources::ConditioningSettings& settings);

 private:
  [[nodiscard]] LiveStream& first() const { return *streams_.front(); }
  void add(std::string name, const sources::LiveOptions& reading, bool with_voice);
  void read_line_by_line(std::string_view bytes, SteadySeconds now);
  void add_faces(SteadySeconds now);
  [[nodiscard]] Result<void> record(LiveStream& stream, bool first);
  void go_on(SteadySeconds now);
  void say();
  void say_neutral();
  void warn_if_unquiet(const std::string& name, const sources::MeasuredNeutral& neutral) const;

  LiveStreamsOptions options_;
  Events events_;
  std::vector<std::unique_ptr<LiveStream>> streams_;  ///< the first one's reader speaks for all
  std::optional<Error> not_recorded_;
  bool catching_up_;
  bool more_faces_said_ = false;
  bool ended_ = false;  ///< for good
};

}  // namespace aucast::server
