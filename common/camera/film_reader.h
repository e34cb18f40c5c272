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
  /// Says which neutral face is subtracted. Above 0: the median over this many seconds from the
  /// beginning; 0: the typical face; nullopt: a face that is found from the whole film
  /// (mesh::find_neutral_face).
  std::optional<double> neutral_seconds{};
  bool several = false;  ///< all faces are read and numbered, at most mesh::FaceRoll::kFacesMax
};

/// How far a film was read.
struct FilmProgress {
  double seconds = 0;           ///< how much of the film was read
  std::optional<double> whole;  ///< the film's length; nullopt: unknown
};

/// What was seen in a film.
struct FilmTable {
  std::string text;  ///< the text of a FaceTable
  std::size_t pictures = 0;
  std::size_t faces = 0;  ///< how many pictures have a face
  std::string note;       ///< the film's name and what is wrong with it; empty: nothing is
};

/// Reads the face in a film. If there are several, reads the clearest or, with options.several,
/// all. Fails as PictureSource and load_face_models() do, and with BadData if no face is seen.
/// If asked to stop, returns stopped_early() at the next picture.
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
