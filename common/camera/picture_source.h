#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/camera/y4m.h"
#include "common/child.h"
#include "common/result.h"
#include "common/stopped.h"
#include "common/time.h"

namespace aucast::camera {

/// The camera, and what is asked of it.
struct CameraOptions {
  std::string device = "/dev/video0";
  int width = 640;
  int height = 480;
  int fps = 30;
  Milliseconds patience{10'000};  ///< the longest wait for the first picture
  friend bool operator==(const CameraOptions&, const CameraOptions&) = default;
};

/// Pictures of a film or a camera, decoded by ffmpeg as a child process: upright, with square
/// pixels, no larger than 640x640. A film of more than 30 pictures a second is reduced to 30.
/// Thread: one at a time, except for stop().
class PictureSource {
 public:
  /// Fails with ErrorKind::Failed if ffmpeg is missing (the message says what to install), with
  /// Unreadable if the file cannot be read, with BadData if ffmpeg finds no pictures in it. Once
  /// the caller gives up, next() finds the end too.
  [[nodiscard]] static Result<PictureSource> open_film(const std::filesystem::path& path,
                                                       const GivenUp& given_up = {});
  /// The device may also be a film, which then plays at its own speed, or a FIFO. Fails with
  /// ErrorKind::Failed if ffmpeg is missing, if it finds no pictures (the message has its words),
  /// if none comes in time or the caller gives up; if there is no such film, as open_film() does.
  [[nodiscard]] static Result<PictureSource> open_camera(const CameraOptions& options,
                                                         const GivenUp& given_up = {});

  [[nodiscard]] const Y4mReader& format() const { return *pictures_; }
  [[nodiscard]] bool next(std::vector<std::uint8_t>& rgb) { return pictures_->next(rgb); }
  /// Makes next() find the end. From any thread.
  void stop() const { ffmpeg_->stop(); }
  /// Waits for ffmpeg to end, and kills it if that takes long. Returns its error messages in one
  /// line; empty when it succeeded.
  [[nodiscard]] std::string complaint();
  /// The same for a film that was read to its end. For a film, ffmpeg succeeds even if it could not
  /// decode a part or if the last picture is cut off; this function reports both.
  [[nodiscard]] std::string film_complaint();

 private:
  PictureSource() = default;
  [[nodiscard]] static Result<PictureSource> open(std::unique_ptr<Child> ffmpeg,
                                                  const std::string& name, ErrorKind kind);
  [[nodiscard]] static Result<PictureSource> open_device(const std::vector<std::string>& arguments,
                                                         const CameraOptions& options,
                                                         const GivenUp& given_up);
  std::unique_ptr<Child> ffmpeg_;
  std::optional<Y4mReader> pictures_;
};

/// The error for a film or camera of which ffmpeg made no picture; `complaint` is what ffmpeg said.
[[nodiscard]] Error no_pictures(ErrorKind kind, const std::string& name,
                                const std::string& complaint);

/// How long a film is, in seconds; nullopt when its file does not say, or the caller gives up.
[[nodiscard]] std::optional<double> film_seconds(const std::filesystem::path& path,
                                                 const GivenUp& given_up = {});

}  // namespace aucast::camera
