#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/camera/camera_feed.h"
#include "common/camera/film_reader.h"
#include "common/camera/picture_source.h"
#include "common/result.h"
#include "common/sources/live_queue.h"
#include "common/sources/live_reader.h"
#include "common/time.h"
#include "protocol/live_feed.h"
#include "protocol/server_session.h"
#include "server/live/recorder.h"
#include "server/streams/live_thinning.h"
#include "server/voice/live_voice.h"

namespace aucast::server {

struct LiveSourceOptions {
  std::filesystem::path path;  ///< "-" is stdin
  bool follow = false;
  sources::LiveOptions reader;
  int classic_min = 20;
  /// After so long a silence the clients get {-2}; 0: never.
  Milliseconds timeout{10'000};
  std::filesystem::path record;   ///< what --record says; empty: nothing is kept
  bool record_first = true;       ///< this is the one that a file is for
  LinkLimits link;                ///< what each client's face and voice may take
  std::filesystem::path voice{};  ///< raw sound of the first stream: "-" or a FIFO; empty: none
  voice::VoiceSettings encoder{};
  Milliseconds voice_delay{0};
  /// Called when the neutral face of the first stream was asked for and has been measured.
  std::function<void(const sources::MeasuredNeutral&)> on_neutral;
  camera::CameraOptions camera;  ///< if the path is one
  camera::QuietOptions quiet;    ///< of a camera
  camera::OnSight on_sight{};    ///< likewise
};

/// What becomes of a source that is still being written: reader -> queue -> thinning -> feed. What
/// a followed file holds already is past: only its last row is sent. When nothing comes the face
/// holds, goes to neutral, and after the time-out the stream ends for those who are there; it goes
/// on when something comes.
///
/// The first stream is there from the beginning; with --face-id all each face that is seen gets
/// another one, read from the same bytes by a reader of its own.
///
/// A voice is the first stream's. While there is one its clock stands still in no pause: the face
/// that stands meanwhile is sent with the time that it stood.
///
/// Knows no file but what it records, and no clock: after every call what is due is sent, next()
/// tells when advance() is wanted.
/// Thread: none of its own.
class LiveStreams {
 public:
  /// More faces than this are not told apart.
  static constexpr std::size_t kFacesMax = 16;

  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new
    /// A face is seen for the first time; its stream is the last of streams().
    std::function<void()> on_face;
  };

  LiveStreams(LiveSourceOptions options, Events events);
  ~LiveStreams();
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
  [[nodiscard]] bool nothing_came() const;
  /// What it is served as, the first stream first.
  [[nodiscard]] std::vector<protocol::ServedStream> served() const;
  /// Other settings of the signals from the next row on.
  void condition(const sources::ConditioningSettings& settings);

 private:
  struct Stream;

  void read_line_by_line(std::string_view bytes, double now);
  void add_faces(std::string_view line, double now);
  [[nodiscard]] Result<void> record(Stream& stream, bool first);
  void go_on(double now);
  void send_voice(std::vector<protocol::VoicePacket> packets, double now);
  void pass(Stream& stream, const protocol::Keyframe& keyframe, bool free, double now);
  void fill_pause(Stream& stream, double now);
  void send(Stream& stream, const sources::LiveKeyframe& keyframe, bool free, double now);
  void send_thinned(Stream& stream, double now);
  void show(Stream& stream, const protocol::Keyframe& keyframe);
  void send_due(Stream& stream, double now);
  void rest(Stream& stream, double now);
  void end(Stream& stream);
  [[nodiscard]] std::optional<double> next_of(const Stream& stream) const;
  [[nodiscard]] std::optional<double> silent_since(const Stream& stream) const;
  [[nodiscard]] static double beat_of(const Stream& stream);
  [[nodiscard]] double patience() const;
  void say();
  void say_neutral();

  LiveSourceOptions options_;
  Events events_;
  std::vector<std::unique_ptr<Stream>> streams_;  ///< the first one's reader speaks for all
  std::optional<Error> not_recorded_;
  bool catching_up_;
  bool more_faces_said_ = false;
  bool ended_ = false;  ///< for good
};

}  // namespace aucast::server
