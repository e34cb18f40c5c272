#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "client/view/image.h"
#include "client/view/video_encoder.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// "face-player-1.png" or the first number that is free: what is there is never overwritten.
[[nodiscard]] std::filesystem::path free_name(const std::filesystem::path& folder,
                                              const std::string& ending);

/// How many pictures of a video that began `since` ago are missing when `written` are in it. A
/// screen draws when it likes; a video has its pictures at equal distances.
[[nodiscard]] std::uint64_t pictures_due(Duration since, int fps, std::uint64_t written);

/// A video of what the window shows, as it happens.
class SessionVideo {
 public:
  static constexpr int kFps = 25;

  [[nodiscard]] static Result<std::unique_ptr<SessionVideo>> open(const std::filesystem::path& file,
                                                                  int width, int height,
                                                                  Instant begin);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool due(Instant now) const;
  /// Puts the picture in as often as it takes to be at `now`.
  [[nodiscard]] Result<void> show(const view::Image& picture, Instant now);
  /// A sentence about where it went.
  [[nodiscard]] Result<std::string> finish();

 private:
  SessionVideo() = default;

  std::filesystem::path file_;
  int width_ = 0;
  int height_ = 0;
  Instant begin_{};
  std::uint64_t written_ = 0;
  std::unique_ptr<view::VideoEncoder> encoder_;
};

}  // namespace aucast::app
