#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/action_unit.h"
#include "common/camera/face_models.h"
#include "common/camera/film_reader.h"
#include "common/camera/picture_source.h"
#include "common/mesh/landmarks.h"
#include "common/mesh/picture.h"
#include "common/result.h"
#include "common/shared.h"

namespace aucast::camera {

/// What a camera sees at one moment. Valid only during the OnSight call.
struct Sight {
  mesh::Picture picture;
  const mesh::Landmarks* landmarks = nullptr;  ///< of the first face; null: none
  std::vector<AuTerm> aus;                     ///< as FaceTable::terms(); none without a face
};
/// Called on the feed's thread that reads faces.
using OnSight = std::function<void(const Sight&)>;

/// A camera as a stream of rows (FaceTable), which come through a pipe as a recogniser's would. One
/// thread takes pictures from ffmpeg, another reads the face of the newest: what comes while it is
/// busy is dropped, so a slow machine shows fewer faces and no late ones. A row's time is when its
/// picture came.
/// Thread: its owner's; two of its own, which end with it.
class CameraFeed {
 public:
  /// Errors are those of PictureSource and load_face_models(). `faces.quiet_seconds`: unset, the
  /// face at rest is found from what was seen so far; 0: the typical face. `on_sight` is told of
  /// every picture whose faces were read, until the feed is destroyed. Waits for the first picture,
  /// as long as that is not `given_up`.
  [[nodiscard]] static Result<std::unique_ptr<CameraFeed>> start(const CameraOptions& options,
                                                                 const FaceOptions& faces,
                                                                 OnSight on_sight = {},
                                                                 const GivenUp& given_up = {});
  ~CameraFeed();
  CameraFeed(const CameraFeed&) = delete;
  CameraFeed& operator=(const CameraFeed&) = delete;

  /// The end of the pipe that rows come from; the caller closes it. Once.
  [[nodiscard]] int take_rows();
  /// After the rows have ended: why ffmpeg did, in one line; empty when it was content.
  [[nodiscard]] std::string complaint();

 private:
  struct TimedPicture {
    double seconds = 0;
    std::vector<std::uint8_t> rgb;
  };

  struct Seen {
    std::optional<TimedPicture> newest;  ///< that nobody has read
    bool ended = false;
  };

  CameraFeed(PictureSource pictures, FaceModels models, const FaceOptions& faces, OnSight on_sight,
             int rows, int write);
  void take_pictures();
  void read_faces();
  [[nodiscard]] std::vector<mesh::SeenFace> look_at(const mesh::Picture& picture);
  [[nodiscard]] bool write(const std::string& text) const;

  PictureSource pictures_;
  FaceModels models_;
  FaceOptions faces_;
  OnSight on_sight_;
  int rows_;   ///< our end to read from, until it was taken
  int write_;  ///< the other one, which the reading thread closes
  Shared<Seen> seen_;
  // The threads come last: they use all of the above.
  std::jthread taking_;
  std::jthread reading_;
};

}  // namespace aucast::camera
