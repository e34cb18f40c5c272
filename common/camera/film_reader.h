#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "common/camera/face_models.h"
#include "common/result.h"

namespace aucast::camera {

/// How faces are read.
struct FaceOptions {
  /// The neutral face, which is subtracted. Above 0: the median of this many first seconds; 0: the
  /// typical face; nullopt: it is found from the whole film (mesh::find_neutral_face).
  std::optional<double> neutral_seconds{};
  bool several = false;  ///< all faces are read and numbered, at most mesh::FaceRoll::kFacesMax
};

/// How far a film was read.
struct FilmProgress {
  double seconds = 0;           ///< of the film, read so far
  std::optional<double> whole;  ///< the film's length; nullopt: unknown
};

/// What was seen in a film.
struct FilmTable {
  std::string text;  ///< a FaceTable
  std::size_t pictures = 0;
  std::size_t faces = 0;  ///< how many pictures have a face
  std::string note;       ///< what was wrong with the film, with its name; empty: nothing
};

/// Reads the face in a film; of several, the clearest, unless options.several. Errors are those of
/// PictureSource and load_face_models(); BadData when no face is seen in it. Asked to stop, it
/// returns stopped_early() at the next picture.
[[nodiscard]] Result<FilmTable> read_film(
    const std::filesystem::path& path, const FaceOptions& options,
    const std::function<void(const FilmProgress&)>& on_progress = {},
    const std::stop_token& stop = {});

/// The same with models that are loaded already.
[[nodiscard]] Result<FilmTable> read_film(
    const std::filesystem::path& path, FaceModels& models, const FaceOptions& options,
    const std::function<void(const FilmProgress&)>& on_progress = {},
    const std::stop_token& stop = {});

}  // namespace aucast::camera
