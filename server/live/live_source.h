#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/result.h"
#include "common/sources/live_queue.h"
#include "common/sources/live_reader.h"
#include "common/time.h"
#include "protocol/live_feed.h"
#include "protocol/server_session.h"
#include "server/live/live_input.h"
#include "server/live/recorder.h"
#include "server/streams/thinning.h"

namespace aucast::server {

struct LiveSourceOptions {
  std::filesystem::path path;  ///< "-" is stdin
  bool follow = false;
  sources::LiveOptions reader;
  int classic_min = 20;
  /// After so long a silence the clients get {-2}; 0: never.
  Milliseconds timeout{10'000};
  std::filesystem::path record;  ///< what --record says; empty: nothing is kept
  bool record_first = true;      ///< this is the one that a file is for
  std::uint32_t max_kbits = 0;   ///< a second for each client and stream; 0: any
  /// Called when the neutral face of the first stream was asked for and has been measured.
  std::function<void(const sources::MeasuredNeutral&)> on_neutral;
};

/// A source that is still being written, as live streams: input -> reader -> queue -> thinning
/// -> feed. What a followed file holds already is past: only its last row is sent. When nothing
/// comes the face holds, goes to neutral, and after the time-out the stream ends for those who are
/// there; it goes on when something comes.
///
/// The first stream is there from the beginning; with --face-id all each face that is seen gets
/// another one, read from the same bytes by a reader of its own.
/// Thread: that of the io_context, which must outlive it.
class LiveSource {
 public:
  /// More faces than this are not told apart.
  static constexpr std::size_t kFacesMost = 16;

  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new
    /// A face is seen for the first time; its stream is the last of streams().
    std::function<void()> on_face;
  };

  LiveSource(asio::io_context& io, LiveSourceOptions options, Events events);
  ~LiveSource();
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;

  [[nodiscard]] Result<void> start();
  void stop();
  /// What kept it from being recorded whole. Waits until the records are written.
  [[nodiscard]] Result<void> finish_record();
  /// Nothing can come any more, and everybody was told so: stdin has ended, which nobody opens
  /// again.
  [[nodiscard]] bool over() const;
  /// It has ended before the first keyframe.
  [[nodiscard]] bool nothing_came() const;
  /// What it is served as, the first stream first.
  [[nodiscard]] std::vector<protocol::ServedStream> streams() const;
  /// Other settings of the signals from the next row on.
  void condition(const sources::ConditioningSettings& settings);

 private:
  struct Stream;

  [[nodiscard]] static double now();
  void on_bytes(std::string_view bytes);
  void read_line_by_line(std::string_view bytes);
  void add_faces(std::string_view line);
  [[nodiscard]] Result<void> record(Stream& stream, bool first);
  void on_caught_up();
  void on_anew(const std::string& why);
  void on_end();
  void go_on();
  void send(Stream& stream, const sources::LiveKeyframe& keyframe, bool free, double moment);
  void send_thinned(Stream& stream, double moment);
  void show(Stream& stream, const protocol::Keyframe& keyframe);
  void send_due(Stream& stream, double moment);
  void rest(Stream& stream, double moment);
  void end(Stream& stream);
  [[nodiscard]] std::optional<double> next_of(const Stream& stream) const;
  [[nodiscard]] double patience() const;
  void wait();
  void say();
  void say_neutral();

  LiveSourceOptions options_;
  Events events_;
  std::vector<std::unique_ptr<Stream>> streams_;  ///< the first one's reader speaks for all
  LiveInput input_;
  asio::steady_timer timer_;
  std::optional<Error> not_recorded_;
  bool catching_up_;
  bool stopped_ = false;
};

}  // namespace aucast::server
