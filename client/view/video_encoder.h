#pragma once

#include <filesystem>
#include <memory>

#include "client/view/image.h"
#include "common/result.h"

namespace aucast::view {

/// A video file written by ffmpeg as a child process: .mp4 (H.264), .webm (VP9) or .gif by the
/// name's ending. The file appears under its name when finish() succeeds; what was there before
/// stays until then. Same pictures, same bytes.
class VideoEncoder {
 public:
  /// Failed with what to install when ffmpeg is missing, or when the place cannot be written; Usage
  /// for an unknown ending, an odd size or fps outside 1-240.
  [[nodiscard]] static Result<std::unique_ptr<VideoEncoder>> open(
      const std::filesystem::path& path, int width, int height, int fps);
  ~VideoEncoder();
  VideoEncoder(const VideoEncoder&) = delete;
  VideoEncoder& operator=(const VideoEncoder&) = delete;

  /// Failed, with ffmpeg's own last words, when it died.
  [[nodiscard]] Result<void> add(const Image& picture);
  [[nodiscard]] Result<void> finish();

 private:
  struct State;
  explicit VideoEncoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::view
