#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "client/view/image.h"
#include "client/view/video_encoder.h"
#include "common/result.h"
#include "common/shared.h"
#include "common/time.h"

namespace aucast::app {

/// Feeds pictures to a video encoder, which may take longer for one than there is until the next.
/// Thread: it has one of its own, on which the encoder blocks; its functions never do, except
/// finish() and the destructor. They are called from one thread at a time.
class VideoFeed {
 public:
  /// How many pictures may wait for the encoder at most, and how many bytes all but one may have.
  static constexpr std::size_t kWaitingMax = 8;
  static constexpr std::size_t kWaitingBytesMax = std::size_t{1} << 27;

  /// See VideoEncoder::open(). Once the video is over, an ffmpeg that does not take a picture
  /// within `patience` is killed.
  [[nodiscard]] static Result<std::unique_ptr<VideoFeed>> start(
      const std::filesystem::path& file, int width, int height, int fps,
      Milliseconds patience = view::VideoEncoder::kPatience);
  /// Without finish(), what waits is dropped and the video is abandoned.
  ~VideoFeed();
  VideoFeed(const VideoFeed&) = delete;
  VideoFeed& operator=(const VideoFeed&) = delete;

  /// If no more pictures may wait, has the newest of them come `times` times more. Else, or if the
  /// encoder has failed, returns false: add() a picture.
  [[nodiscard]] bool repeat_newest(std::uint64_t times);
  /// Adds a picture that comes `times` times. Fails if the encoder has failed at an earlier one.
  [[nodiscard]] Result<void> add(view::Image picture, std::uint64_t times);
  /// Waits until the encoder has taken all pictures, and completes the file; see
  /// VideoEncoder::finish(). Call it once, as the last.
  [[nodiscard]] Result<void> finish(const std::filesystem::path& sound);

 private:
  struct Waiting {
    view::Image picture;
    std::uint64_t times = 0;
  };
  struct Course {
    std::deque<Waiting> waiting;
    bool abandoned = false;  ///< what waits is not needed any more
    std::optional<Error> failure;
  };

  explicit VideoFeed(std::size_t waiting_max) : waiting_max_(waiting_max) {}
  void run();
  [[nodiscard]] Result<void> feed(const Waiting& next);

  std::size_t waiting_max_;
  std::stop_source stop_;  ///< nothing more will be added
  Shared<Course> course_;
  std::unique_ptr<view::VideoEncoder> encoder_;  ///< the thread's until that has ended
  std::jthread thread_;                          ///< last: it ends before anything it uses is gone
};

}  // namespace aucast::app
