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
  bool follow = false;           ///< the source is a file that is followed
  std::filesystem::path record;  ///< the value of --record; empty: nothing is recorded
  bool record_first = true;      ///< if `record` is a file, it is for this source
  /// Takes the name for the stream of a further face; false: another stream has it. None: every
  /// name is free.
  std::function<bool(const std::string& name)> take_name{};
};

/// The streams of one source that is being written. Of what a followed file already has, only the
/// last row is sent.
///
/// The first stream exists from the beginning, and has the voice, if there is one. With --face-id
/// all, each further face that is seen gets another stream, whose own reader reads the same bytes.
///
/// Uses no file except its records, and no clock: every call also sends what is due, and next()
/// returns when advance() has to be called.
/// Thread: none of its own.
class LiveStreams {
 public:
  /// The most streams besides the first one; further faces get none.
  static constexpr std::size_t kFaceStreamsMax = 16;

  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new
    /// A face is seen for the first time; its stream is the last of served().
    std::function<void()> on_face;
    /// The neutral face of the first stream has been measured; only if that was asked for.
    std::function<void(const sources::MeasuredNeutral&)> on_neutral =
        [](const sources::MeasuredNeutral&) {};
  };

  LiveStreams(LiveStreamsOptions options, Events events);
  LiveStreams(const LiveStreams&) = delete;
  LiveStreams& operator=(const LiveStreams&) = delete;

  /// Opens the record, if there is to be one. Fails as Recorder::start() does.
  [[nodiscard]] Result<void> start();

  void feed(std::string_view bytes, Instant now);
  /// Everything that a followed file already had has been fed.
  void caught_up(Instant now);
  /// The file is read from its beginning again; `why`, for the log, is a clause.
  void begin_anew(const std::string& why);
  /// The writer has gone. `for_good`: nobody can write any more.
  void end_input(Instant now, bool for_good);
  /// Takes raw sound, as LiveVoice::add() does.
  void feed_voice(std::string_view bytes, Instant now);
  /// The writer of the sound has gone.
  void end_voice(Instant now);
  /// As LiveStream::go_on(), for all streams.
  void advance(Instant now);
  /// When to call advance() next; nullopt: not before something is fed.
  [[nodiscard]] std::optional<Instant> next() const;
  /// Whether a stream's queue is full: feed nothing for now.
  [[nodiscard]] bool full() const;

  /// Waits until the records are written. Fails with what ended one early, if anything did.
  [[nodiscard]] Result<void> finish_record();
  /// Whether nothing can come any more, and all clients were told so.
  [[nodiscard]] bool over() const;
  /// Whether the source has ended before its first keyframe.
  [[nodiscard]] bool nothing_came() const { return ended_ && !first().begun(); }
  /// The streams as they are served, the first one first.
  [[nodiscard]] std::vector<protocol::ServedStream> served() const;
  /// Uses other settings for the signals from the next row on.
  void condition(const sources::ConditioningSettings& settings);

 private:
  [[nodiscard]] LiveStream& first() const { return *streams_.front(); }
  void add(std::string name, const sources::LiveOptions& reading, bool with_voice);
  void read_line_by_line(std::string_view bytes, SteadyTime now);
  void add_faces(SteadyTime now);
  [[nodiscard]] Result<void> record(LiveStream& stream, bool first);
  void go_on(SteadyTime now);
  void say();
  void say_neutral();
  void warn_unless_neutral(const std::string& name, const sources::MeasuredNeutral& neutral) const;

  LiveStreamsOptions options_;
  Events events_;
  std::vector<std::unique_ptr<LiveStream>> streams_;  ///< the first one's messages are logged
  std::optional<Error> not_recorded_;
  bool catching_up_;
  bool more_faces_said_ = false;
  bool ended_ = false;  ///< for good
};

}  // namespace aucast::server
