#include "common/camera/film_reader.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "common/camera/face_table.h"
#include "common/camera/picture_source.h"
#include "common/mesh/neutral_face.h"
#include "common/mesh/read_aus.h"
#include "common/mesh/sob_watch.h"
#include "common/mesh/steady_gaze.h"
#include "common/stopped.h"
#include "common/text.h"

namespace aucast::camera {
namespace {

/// Ten hours at 30 pictures a second.
constexpr std::size_t kPicturesMax = 1'080'000;
constexpr std::size_t kProgressEvery = 30;

struct Seen {
  std::size_t face = 0;  ///< its number
  double presence = 0;
  std::size_t measures = 0;  ///< index among the measures of this face
};

/// All that is measured in a film, picture by picture.
struct Film {
  double fps = 0;
  std::vector<std::vector<Seen>> pictures;
  std::vector<std::vector<mesh::Measures>> faces;  ///< of each face, as often as it was seen
  std::string note;                                ///< what was wrong with it

  void add(std::vector<Seen>& picture, std::size_t number, const mesh::Landmarks& landmarks) {
    if (faces.size() <= number) faces.resize(number + 1);
    picture.push_back({number, landmarks.presence, faces[number].size()});
    faces[number].push_back(mesh::measure(mesh::fit_head(landmarks, mesh::kTypicalStillPoints)));
  }
};

Result<Film> measure_film(const std::filesystem::path& path, mesh::FaceTracker& tracker,
                          bool several, const std::function<void(const FilmProgress&)>& on_progress,
                          const std::stop_token& stop) {
  const GivenUp given_up = [&stop] { return stop.stop_requested(); };
  auto source = PictureSource::open_film(path, given_up);
  if (stop.stop_requested()) return stopped_early();
  if (!source) return source.error();
  Film film;
  film.fps = source->format().fps();
  const mesh::Picture size{source->format().width(), source->format().height(), {}};
  const auto whole = on_progress ? film_seconds(path, given_up) : std::nullopt;
  std::vector<std::uint8_t> rgb;
  while (source->next(rgb)) {
    if (stop.stop_requested()) return stopped_early();
    if (film.pictures.size() == kPicturesMax) {
      return Error{ErrorKind::BadData,
                   at_place(path.string(), "it has more than " + std::to_string(kPicturesMax) +
                                               " pictures; cut it")};
    }
    const mesh::Picture picture{size.width, size.height, rgb};
    std::vector<Seen>& seen = film.pictures.emplace_back();
    if (several) {
      for (const auto& face : tracker.follow_all(picture)) {
        film.add(seen, face.number, face.landmarks);
      }
    } else if (const auto face = tracker.follow(picture)) {
      film.add(seen, 0, *face);
    }
    if (on_progress && film.pictures.size() % kProgressEvery == 0) {
      on_progress({static_cast<double>(film.pictures.size()) / film.fps, whole});
    }
  }
  // A child that was killed looks as one that has ended.
  if (stop.stop_requested()) return stopped_early();
  if (film.pictures.empty()) {
    return no_pictures(ErrorKind::BadData, path.string(), source->complaint());
  }
  if (const std::string complaint = source->film_complaint(); !complaint.empty()) {
    film.note =
        at_place(path.string(), "not all of it can be read, " +
                                    counted(film.pictures.size(), "picture") + "; " + complaint);
  }
  return film;
}

mesh::Measures neutral_of(std::span<const mesh::Measures> face, double fps,
                          const mesh::AuWeights& weights, const FaceOptions& options) {
  if (!options.neutral_seconds) return mesh::find_neutral_face(face, weights);
  const auto count = static_cast<std::size_t>(*options.neutral_seconds * fps);
  return mesh::median_face(face.first(std::min(count, face.size())), weights);
}

}  // namespace

Result<FilmTable> read_film(const std::filesystem::path& path, const FaceOptions& options,
                            const std::function<void(const FilmProgress&)>& on_progress,
                            const std::stop_token& stop) {
  auto models = load_face_models();
  if (!models) {
    return Error{models.error().kind, at_place(path.string(), models.error().message)};
  }
  return read_film(path, *models, options, on_progress, stop);
}

Result<FilmTable> read_film(const std::filesystem::path& path, FaceModels& models,
                            const FaceOptions& options,
                            const std::function<void(const FilmProgress&)>& on_progress,
                            const std::stop_token& stop) {
  auto film = measure_film(path, models.tracker, options.several, on_progress, stop);
  if (!film) return film.error();
  if (film->faces.empty()) {
    return Error{ErrorKind::BadData,
                 at_place(path.string(),
                          "no face is seen in its " + counted(film->pictures.size(), "picture"))};
  }
  std::vector<mesh::Measures> neutral;
  for (auto& face : film->faces) {
    mesh::steady_gaze(face);
    neutral.push_back(neutral_of(face, film->fps, models.weights, options));
  }
  std::vector<mesh::SobWatch> sobs(film->faces.size());
  const FaceTable table(models.weights, options.several);
  FilmTable result{table.header(), film->pictures.size(), 0, film->note};
  for (std::size_t picture = 0; picture < film->pictures.size(); ++picture) {
    const double seconds = static_cast<double>(picture) / film->fps;
    const std::vector<Seen>& seen = film->pictures[picture];
    if (seen.empty()) result.text += table.row(seconds, 0, std::nullopt);
    for (const auto& [number, presence, measures] : seen) {
      AuFrame face = mesh::read_aus(models.weights, film->faces[number][measures], neutral[number]);
      sobs[number].watch(seconds, face);
      result.text += table.row(seconds, presence, face, number);
    }
    if (!seen.empty()) ++result.faces;
  }
  return result;
}

}  // namespace aucast::camera
