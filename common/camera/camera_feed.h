#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/camera/face_models.h"
#include "common/camera/film_reader.h"
#include "common/camera/picture_source.h"
#include "common/result.h"

namespace aucast::camera {

/// A camera as a stream of rows (FaceTable), which come through a pipe as a recogniser's would. One
/// thread takes pictures from ffmpeg, another reads the face of the newest: what comes while it is
/// busy is dropped, so a slow machine shows fewer faces and no late ones. A row's time is when its
/// picture came.
/// Thread: its owner's; two of its own, which end with it.
class CameraFeed {
 public:
  /// Errors are those of PictureSource and load_face_models(). `quiet`: without seconds, or with 0,
  /// as for a film, but of what was seen so far.
  [[nodiscard]] static Result<std::unique_ptr<CameraFeed>> start(const CameraOptions& options,
                                                                 const QuietOptions& quiet);
  ~CameraFeed();
  CameraFeed(const CameraFeed&) = delete;
  CameraFeed& operator=(const CameraFeed&) = delete;

  /// The end of the pipe that rows come from; the caller closes it. Once.
  [[nodiscard]] int take_rows();
  /// After the rows have ended: why ffmpeg did, in one line; empty when it was content.
  [[nodiscard]] std::string complaint();

 private:
  struct Picture {
    double seconds = 0;
    std::vector<std::uint8_t> rgb;
  };

  CameraFeed(PictureSource pictures, FaceModels models, const QuietOptions& quiet, int rows,
             int write);
  void take_pictures();
  void read_faces();
  [[nodiscard]] bool write(const std::string& text) const;

  PictureSource pictures_;
  FaceModels models_;
  QuietOptions quiet_;
  int rows_;   ///< our end to read from, until it was taken
  int write_;  ///< the other one, which the reading thread closes
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_:
  std::optional<Picture> newest_;
  bool ended_ = false;
  // The threads come last: they use all of the above.
  std::jthread taking_;
  std::jthread reading_;
};

}  // namespace aucast::camera
