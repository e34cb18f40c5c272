#include "common/camera/film_reader.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "common/camera/face_table.h"
#include "common/camera/picture_source.h"
#include "common/mesh/quiet_face.h"
#include "common/mesh/read_aus.h"
#include "common/text.h"

namespace aucast::camera {
namespace {

/// Ten hours at 30 pictures a second.
constexpr std::size_t kPicturesMax = 1'080'000;
constexpr std::size_t kProgressEvery = 30;

struct Seen {
  double presence = 0;
  std::optional<std::size_t> measures;  ///< which of those that were taken
};

/// All that is measured in a film, picture by picture.
struct Film {
  double fps = 0;
  std::vector<Seen> pictures;
  std::vector<mesh::Measures> measures;
  std::string note;  ///< what was wrong with it
};

Result<Film> measure_film(const std::filesystem::path& path, mesh::FaceTracker& tracker,
                          const std::function<void(const FilmProgress&)>& on_progress) {
  auto source = PictureSource::open_film(path);
  if (!source) return source.error();
  Film film;
  film.fps = source->format().fps();
  const mesh::Picture size{source->format().width(), source->format().height(), {}};
  const auto whole = on_progress ? film_seconds(path) : std::nullopt;
  std::vector<std::uint8_t> rgb;
  while (source->next(rgb)) {
    if (film.pictures.size() == kPicturesMax) {
      return Error{ErrorKind::BadData,
                   at_place(path.string(), "it has more than " + std::to_string(kPicturesMax) +
                                               " pictures; cut it")};
    }
    Seen seen;
    if (const auto face = tracker.follow({size.width, size.height, rgb})) {
      seen = {face->presence, film.measures.size()};
      film.measures.push_back(mesh::measure(mesh::fit_head(*face, mesh::kTypicalStillPoints)));
    }
    film.pictures.push_back(seen);
    if (on_progress && film.pictures.size() % kProgressEvery == 0) {
      on_progress({static_cast<double>(film.pictures.size()) / film.fps, whole});
    }
  }
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

mesh::Measures quiet_of(const Film& film, const mesh::AuWeights& weights,
                        const QuietOptions& options) {
  if (!options.seconds) return mesh::find_quiet_face(film.measures, weights);
  const auto count = static_cast<std::size_t>(*options.seconds * film.fps);
  return mesh::median_face(std::span(film.measures).first(std::min(count, film.measures.size())),
                           weights);
}

}  // namespace

bool is_film(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 14> kEndings{".mp4", ".m4v", ".mov",  ".mkv", ".webm",
                                                      ".avi", ".mpg", ".mpeg", ".ts",  ".wmv",
                                                      ".flv", ".ogv", ".3gp",  ".y4m"};
  const std::string ending = lowered(path.extension().string());
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

Result<FilmTable> read_film(const std::filesystem::path& path, const QuietOptions& quiet,
                            const std::function<void(const FilmProgress&)>& on_progress) {
  auto models = load_face_models();
  if (!models) {
    return Error{models.error().kind, at_place(path.string(), models.error().message)};
  }
  return read_film(path, *models, quiet, on_progress);
}

Result<FilmTable> read_film(const std::filesystem::path& path, FaceModels& models,
                            const QuietOptions& quiet,
                            const std::function<void(const FilmProgress&)>& on_progress) {
  const auto film = measure_film(path, models.tracker, on_progress);
  if (!film) return film.error();
  if (film->measures.empty()) {
    return Error{ErrorKind::BadData,
                 at_place(path.string(),
                          "no face is seen in its " + counted(film->pictures.size(), "picture"))};
  }
  const mesh::Measures rest = quiet_of(*film, models.weights, quiet);
  const FaceTable table(models.weights);
  FilmTable result{table.header(), film->pictures.size(), film->measures.size(), film->note};
  for (std::size_t picture = 0; picture < film->pictures.size(); ++picture) {
    const Seen& seen = film->pictures[picture];
    std::optional<AuFrame> face;
    if (seen.measures) face = mesh::read_aus(models.weights, film->measures[*seen.measures], rest);
    result.text += table.row(static_cast<double>(picture) / film->fps, seen.presence, face);
  }
  return result;
}

}  // namespace aucast::camera
