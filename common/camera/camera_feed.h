#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/action_unit.h"
#include "common/camera/face_models.h"
#include "common/camera/film_reader.h"
#include "common/camera/picture_source.h"
#include "common/descriptor.h"
#include "common/mesh/landmarks.h"
#include "common/mesh/picture.h"
#include "common/result.h"
#include "common/shared.h"

namespace aucast::camera {

/// What a camera sees at one moment. Valid only during the OnSight call.
struct Sight {
  mesh::Picture picture;
  const mesh::Landmarks* landmarks = nullptr;  ///< of the first face; null: no face is seen
  std::vector<AuTerm> aus;                     ///< as FaceTable::terms() gives them; empty: no face
};
/// Called on the feed's thread that reads faces, once for each picture that it has read.
using OnSight = std::function<void(const Sight&)>;

/// Turns a camera into rows (FaceTable), which come through a pipe as a recogniser's rows would.
/// One thread takes pictures from ffmpeg, a second one reads the faces of the newest picture.
/// Pictures that come while the second one is busy are dropped, so on a slow machine there are
/// fewer rows, but none is late. A row's time is when its picture came.
/// Thread: that of its owner. The feed has two threads of its own, which its destructor ends.
class CameraFeed {
 public:
  /// Waits for the first picture until one comes, CameraOptions::patience ends or `given_up`
  /// returns true. Errors are those of PictureSource and load_face_models(). With
  /// `faces.neutral_seconds` 0 the neutral face is the typical one, otherwise it is found from what
  /// was seen so far. `on_sight` is called until the feed is destroyed.
  [[nodiscard]] static Result<std::unique_ptr<CameraFeed>> start(const CameraOptions& options,
                                                                 const FaceOptions& faces,
                                                                 OnSight on_sight = {},
                                                                 const GivenUp& given_up = {});
  ~CameraFeed();
  CameraFeed(const CameraFeed&) = delete;
  CameraFeed& operator=(const CameraFeed&) = delete;

  /// Gives away the end of the pipe from which rows are read. Call this only once.
  [[nodiscard]] Descriptor take_rows() { return std::move(rows_); }
  /// Returns in one line why ffmpeg ended; empty when it reported no error. Call it after the rows
  /// have ended. Waits for nothing.
  [[nodiscard]] std::string complaint() const;
  /// How many rows were dropped, because the reader of the rows was behind by a whole pipe.
  [[nodiscard]] std::uint64_t rows_left_out() const;

 private:
  struct TimedPicture {
    double seconds = 0;
    std::vector<std::uint8_t> rgb;
  };

  struct Seen {
    std::optional<TimedPicture> newest;  ///< whose faces are not read yet; nullopt: none
    bool ended = false;
    std::uint64_t rows_left_out = 0;
    std::string complaint;  ///< why ffmpeg ended; known when the pictures have ended
  };

  CameraFeed(PictureSource pictures, FaceModels models, const FaceOptions& faces, OnSight on_sight,
             Descriptor rows, Descriptor write);
  void take_pictures();
  void read_faces();
  [[nodiscard]] std::vector<mesh::SeenFace> look_at(const mesh::Picture& picture);
  [[nodiscard]] bool write(const std::string& text);

  PictureSource pictures_;
  FaceModels models_;
  FaceOptions faces_;
  OnSight on_sight_;
  Descriptor rows_;   ///< the end of the pipe for reading, until take_rows()
  Descriptor write_;  ///< the end for writing, which the thread `reading_` closes
  Shared<Seen> seen_;
  // The threads are declared last, since they use all of the above.
  std::jthread taking_;
  std::jthread reading_;
};

}  // namespace aucast::camera
