#pragma once

#include <filesystem>
#include <memory>

#include "client/view/image.h"
#include "common/result.h"
#include "common/stopped.h"
#include "common/time.h"

namespace aucast::view {

inline constexpr int kVideoSideMax = 8192;
inline constexpr int kVideoFpsMax = 240;

/// A video file written by ffmpeg as a child process: .mp4 (H.264), .webm (VP9) or .gif by the
/// name's ending. The file appears under its name when finish() succeeds; a file that was there
/// before stays until then. If finish() does not succeed, nothing is left behind. The same pictures
/// give the same bytes. H.264 and VP9 store colour for pairs of pixels: an odd width or height
/// grows by one, repeating the last column or row. A GIF has at most 50 pictures a second; ffmpeg
/// keeps all its pictures in memory until the end to find one palette for them.
class VideoEncoder {
 public:
  /// How long ffmpeg may seem to do nothing when the user wants to stop. Large pictures take
  /// seconds.
  static constexpr Milliseconds kPatience{15'000};

  /// Fails with ErrorKind::Failed if ffmpeg is missing (the message says what to install) or the
  /// file cannot be written there; with Usage if the ending is unknown, a side is not 1 to
  /// kVideoSideMax, or fps is not 1 to kVideoFpsMax. Once `stop` returns true, an ffmpeg that has
  /// neither taken a picture nor written anything for `patience` is killed;
  /// after the last picture, for four times as long.
  [[nodiscard]] static Result<std::unique_ptr<VideoEncoder>> open(
      const std::filesystem::path& path, int width, int height, int fps, GivenUp stop = {},
      Milliseconds patience = kPatience);
  ~VideoEncoder();
  VideoEncoder(const VideoEncoder&) = delete;
  VideoEncoder& operator=(const VideoEncoder&) = delete;

  /// Whether a video of this name can have sound.
  [[nodiscard]] static bool takes_sound(const std::filesystem::path& path);

  /// Adds a picture of the size given to open(). If ffmpeg has died, fails with the end of its
  /// messages, and every later call fails in the same way.
  [[nodiscard]] Result<void> add(const Image& picture);
  /// Waits until ffmpeg is done. If no picture was added, there is no file, which is not an error.
  /// `sound`: a WAV file that begins with the first picture; empty: none. A GIF has no sound.
  [[nodiscard]] Result<void> finish(const std::filesystem::path& sound = {});

 private:
  struct State;
  explicit VideoEncoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::view
