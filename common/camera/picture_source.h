#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/camera/y4m.h"
#include "common/child.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::camera {

/// A camera as it is asked for.
struct CameraOptions {
  std::string device = "/dev/video0";
  int width = 640;
  int height = 480;
  int fps = 30;
  Milliseconds patience{10'000};  ///< for its first picture
  friend bool operator==(const CameraOptions&, const CameraOptions&) = default;
};

/// Asked again and again while the first picture of a camera is awaited: nobody waits any more.
using GivenUp = std::function<bool()>;

/// Pictures of a film or a camera, decoded by ffmpeg as a child: upright, with square pixels, no
/// larger than 640x640. A film of more than 30 pictures a second gives 30.
/// Thread: one at a time, but for stop().
class PictureSource {
 public:
  /// Failed when ffmpeg is missing (the message says what to install); Unreadable for a file that
  /// cannot be read; BadData when ffmpeg finds no pictures in it.
  [[nodiscard]] static Result<PictureSource> open_film(const std::filesystem::path& path);
  /// A film or a FIFO may stand in for the device; a film goes by its own clock then. Failed, with
  /// ffmpeg's own words, when the device gives no pictures, none in time, or when it is given up.
  [[nodiscard]] static Result<PictureSource> open_camera(const CameraOptions& options,
                                                         const GivenUp& given_up = {});

  [[nodiscard]] const Y4mReader& format() const { return *pictures_; }
  [[nodiscard]] bool next(std::vector<std::uint8_t>& rgb) { return pictures_->next(rgb); }
  /// From any thread: next() finds the end.
  void stop() const { ffmpeg_->stop(); }
  /// What ffmpeg said when it ended, in one line; empty when it was content.
  [[nodiscard]] std::string complaint();
  /// The same at the end of a film, where ffmpeg goes on after what it cannot decode and is content
  /// with half a picture too.
  [[nodiscard]] std::string film_complaint();

 private:
  PictureSource() = default;
  [[nodiscard]] static Result<PictureSource> open(const std::vector<std::string>& arguments,
                                                  const std::string& name, ErrorKind kind,
                                                  std::optional<Milliseconds> patience = {},
                                                  const GivenUp& given_up = {});
  std::unique_ptr<Child> ffmpeg_;
  std::optional<Y4mReader> pictures_;
};

/// What to report when ffmpeg has ended without a picture of a film or camera; with its
/// complaint().
[[nodiscard]] Error no_pictures(ErrorKind kind, const std::string& name,
                                const std::string& complaint);

/// How long a film is, in seconds; nothing when nobody knows.
[[nodiscard]] std::optional<double> film_seconds(const std::filesystem::path& path);

}  // namespace aucast::camera
