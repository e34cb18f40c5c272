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
#include "common/time.h"
#include "protocol/live_feed.h"
#include "protocol/server_session.h"
#include "server/live_input.h"
#include "server/recorder.h"
#include "server/sources/live_queue.h"
#include "server/sources/live_reader.h"
#include "server/thinning.h"

namespace aucast::server {

struct LiveSourceOptions {
  std::filesystem::path path;  ///< "-" is stdin
  bool follow = false;
  sources::LiveOptions reader;
  int classic_min = 20;
  /// After so long a silence the clients get {-2}; 0: never.
  Milliseconds timeout{10'000};
  std::filesystem::path record;  ///< where it is kept; empty: nowhere
  std::uint32_t max_kbits = 0;   ///< a second for each client; 0: any
};

/// A source that is still being written, as a live stream: input -> reader -> queue -> thinning ->
/// feed. What a followed file holds already is past: only its last row is sent. When nothing comes
/// the face holds, goes to neutral, and after the time-out the stream ends for those who are there;
/// it goes on when something comes. Thread: that of the io_context, which must outlive it.
class LiveSource {
 public:
  using OnMoment = std::function<void()>;

  LiveSource(asio::io_context& io, LiveSourceOptions options, OnMoment on_moment);
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;

  [[nodiscard]] Result<void> start();
  void stop();
  /// What kept it from being recorded whole. Waits until the record is written.
  [[nodiscard]] Result<void> finish_record();
  /// Nothing can come any more, and everybody was told so: stdin has ended, which nobody opens
  /// again.
  [[nodiscard]] bool over() const { return input_.ended() && feed_.ended() && queue_.size() == 0; }
  /// It has ended before the first keyframe.
  [[nodiscard]] bool nothing_came() const { return input_.ended() && !feed_.newest(); }
  /// What its keyframes go to.
  [[nodiscard]] protocol::LiveFeed& feed() { return feed_; }

 private:
  [[nodiscard]] static double now();
  void on_bytes(std::string_view bytes);
  void on_caught_up();
  void on_anew(const std::string& why);
  void take();
  void go_on();
  void send(const sources::LiveKeyframe& keyframe, bool free, double moment);
  void send_thinned(double moment);
  void show(const protocol::Keyframe& keyframe);
  void send_due(double moment);
  void rest(double moment);
  [[nodiscard]] double patience() const;
  void wait();
  void say();

  LiveSourceOptions options_;
  OnMoment on_moment_;
  protocol::LiveFeed feed_;
  sources::LiveReader reader_;
  sources::LiveQueue queue_;
  LiveThinning thinning_;
  LiveInput input_;
  std::unique_ptr<Recorder> recorder_;
  asio::steady_timer timer_;
  bool catching_up_;
  bool silence_said_ = true;
  bool stopped_ = false;
};

/// The name of the stream that a source is served as: the file's stem.
[[nodiscard]] std::string stream_name(const std::filesystem::path& path);

/// Whether a path is a live source: stdin, a FIFO or another stream; and files, with `follow`.
[[nodiscard]] bool is_live(const std::filesystem::path& path, bool follow);

}  // namespace aucast::server
