#include "client/face/classic_folder.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include <glm/geometric.hpp>

#include "client/face/au_recordings.h"
#include "client/face/classic_scanner.h"
#include "client/face/muscle_file.h"
#include "client/face/opposed_channels.h"
#include "common/files.h"
#include "common/text.h"

namespace aucast::face {
namespace {

constexpr std::size_t kFileBytesMax = std::size_t{16} << 20U;
constexpr std::size_t kPointsMax = 100'000;
constexpr std::size_t kRowsMax = 200'000;
constexpr std::size_t kMusclesMax = 1000;
constexpr std::size_t kTriangleMark = 1000;
constexpr float kActivationMax = 4;
constexpr glm::vec4 kSkinColour{0.74F, 0.505F, 0.385F, 1.0F};

using Row = std::vector<std::uint32_t>;

/// The half of the face that the files hold, and the number of each point's mirror.
struct HalfFace {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> mirror_of;
  std::vector<Row> rows;
};

/// Runs `read(scanner, problems)` over a whole file.
template <typename Read>
Result<void> scan_file(const std::filesystem::path& path, Read read) {
  const auto bytes = read_file(path, kFileBytesMax);
  if (!bytes) return bytes.error();
  Problems problems(path.string());
  ClassicScanner scanner(*bytes, problems);
  read(scanner, problems);
  if (problems.none()) scanner.end();
  return problems.result();
}

glm::vec3 scan_point(ClassicScanner& scanner, const std::string& of) {
  glm::vec3 point{0};
  point.x = scanner.number("x of " + of);
  point.y = scanner.number("y of " + of);
  point.z = scanner.number("z of " + of);
  return point;
}

Result<void> read_points(const std::filesystem::path& path, HalfFace& half) {
  return scan_file(path, [&half](ClassicScanner& scanner, const Problems& problems) {
    const std::size_t count = scanner.count("the number of points", 3, kPointsMax);
    for (std::size_t i = 0; i < count && problems.none(); ++i) {
      half.points.push_back(scan_point(scanner, "point " + std::to_string(i + 1)));
    }
  });
}

Result<void> read_rows(const std::filesystem::path& path, HalfFace& half) {
  return scan_file(path, [&half](ClassicScanner& scanner, const Problems& problems) {
    const std::size_t count = scanner.count("the number of rows", 1, kRowsMax);
    for (std::size_t i = 0; i < count && problems.none(); ++i) {
      Row row;
      for (int corner = 0; corner < 4 && problems.none(); ++corner) {
        const std::string what = "a corner of row " + std::to_string(i + 1);
        const std::size_t point =
            scanner.count(what, 1, std::max(half.points.size(), kTriangleMark));
        if (point == kTriangleMark) continue;
        if (point > half.points.size()) {
          scanner.wrong(what + " is " + std::to_string(point) + ", but there are " +
                        std::to_string(half.points.size()) + " points");
        }
        if (problems.none()) row.push_back(static_cast<std::uint32_t>(point - 1));
      }
      if (problems.none() && std::set<std::uint32_t>(row.begin(), row.end()).size() < 3) {
        scanner.wrong("row " + std::to_string(i + 1) + " has fewer than three different corners");
      }
      half.rows.push_back(std::move(row));
    }
  });
}

Result<void> read_muscles_dat(const std::filesystem::path& path, Face& face) {
  return scan_file(path, [&face](ClassicScanner& scanner, const Problems& problems) {
    const std::size_t count = scanner.count("the number of muscles", 0, kMusclesMax);
    for (std::size_t i = 0; i < count && problems.none(); ++i) {
      Muscle muscle;
      muscle.name = scanner.word("the name of muscle " + std::to_string(i + 1));
      if (problems.none() && face.channel_index(muscle.name)) {
        scanner.wrong("the muscle '" + muscle.name + "' is there twice");
      }
      LinearMuscle shape;
      shape.insertion = scan_point(scanner, "the insertion of " + muscle.name);
      shape.attachment = scan_point(scanner, "the attachment of " + muscle.name);
      if (shape.insertion == shape.attachment) {
        scanner.wrong("insertion and attachment of " + muscle.name + " are the same point");
      }
      shape.falloff_start = scanner.number("the fall-off start of " + muscle.name, {.low = 0});
      shape.falloff_finish =
          scanner.number("the fall-off finish of " + muscle.name, Bounds::above(0));
      if (shape.falloff_finish <= shape.falloff_start) {
        scanner.wrong("the fall-off finish of " + muscle.name + " must be above its start");
      }
      shape.zone_rad =
          kRadPerDeg * scanner.number("the zone of " + muscle.name, Bounds::inside(0, 90));
      static_cast<void>(scanner.number("the clamp of " + muscle.name));
      shape.cap.reset();
      muscle.shape = shape;
      muscle.activation_max = kActivationMax;
      face.channels.push_back({muscle.name, side_at(shape.insertion.x), muscle.activation_max});
      face.muscles.push_back(std::move(muscle));
    }
  });
}

Result<void> read_jaw_dat(const std::filesystem::path& path, const HalfFace& half, Face& face) {
  std::vector<float> map(face.mesh.positions.size(), 0.0F);
  auto done = scan_file(path, [&](ClassicScanner& scanner, const Problems& problems) {
    const std::size_t count = scanner.count("the number of jaw points", 1, half.points.size());
    for (std::size_t i = 0; i < count && problems.none(); ++i) {
      const std::string row = "row " + std::to_string(i + 1);
      const std::size_t point = scanner.count("the point of " + row, 1, half.points.size());
      const float weight = scanner.number("the weight of " + row, Bounds::between(0, 1));
      if (!problems.none()) return;
      map[point - 1] = weight;
      map[half.mirror_of[point - 1]] = weight;
    }
    if (problems.none() && face.channel_index("jaw")) {
      scanner.wrong("there is a muscle named jaw beside the jaw");
    }
  });
  if (!done) return done;
  face.mesh.maps["jaw"] = std::move(map);
  face.jaw = Jaw{};
  face.channels.push_back({"jaw", Side::Both, kActivationMax});
  return {};
}

void mirror_points(HalfFace& half, FaceMesh& mesh) {
  mesh.positions = half.points;
  for (std::size_t i = 0; i < half.points.size(); ++i) {
    const glm::vec3& point = half.points[i];
    if (point.x == 0) {
      half.mirror_of.push_back(static_cast<std::uint32_t>(i));
      continue;
    }
    half.mirror_of.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(-point.x, point.y, point.z);
  }
}

/// Most of a face looks at the viewer: when the rows as a whole do not, they run clockwise.
bool rows_run_clockwise(const HalfFace& half) {
  double towards_viewer = 0;
  for (const Row& row : half.rows) {
    for (std::size_t k = 1; k + 1 < row.size(); ++k) {
      const glm::dvec3 a(half.points[row[0]]);
      const glm::dvec3 b(half.points[row[k]]);
      const glm::dvec3 c(half.points[row[k + 1]]);
      towards_viewer += glm::cross(b - a, c - a).z;
    }
  }
  return towards_viewer < 0;
}

void build_mesh(HalfFace& half, Face& face) {
  FaceMesh& mesh = face.mesh;
  mirror_points(half, mesh);
  const bool clockwise = rows_run_clockwise(half);
  std::set<Row> known;
  std::size_t repeated = 0;
  const auto add = [&](Row row, bool reverse) {
    Row sorted = row;
    std::sort(sorted.begin(), sorted.end());
    if (!known.insert(sorted).second) return ++repeated, void();
    if (reverse) std::reverse(row.begin(), row.end());
    for (std::size_t k = 1; k + 1 < row.size(); ++k) {
      mesh.triangles.push_back({row[0], row[k], row[k + 1]});
    }
  };
  for (const Row& row : half.rows) {
    add(row, clockwise);
    Row mirrored_row;
    for (const std::uint32_t point : row) mirrored_row.push_back(half.mirror_of[point]);
    add(std::move(mirrored_row), !clockwise);
  }
  if (repeated > 0) {
    face.remarks.push_back(
        "index.dat: " + std::to_string(repeated) +
        (repeated == 1 ? " repeated polygon was dropped" : " repeated polygons were dropped"));
  }
  const std::size_t count = mesh.positions.size();
  mesh.parts = {{"skin", Material::Skin, 0, static_cast<std::uint32_t>(count), 0,
                 static_cast<std::uint32_t>(mesh.triangles.size())}};
  mesh.colours.assign(count, kSkinColour);
  mesh.occlusion.assign(count, 1.0F);
  mesh.gloss.assign(count, 1.0F);
}

/// A muscle's name without its side, in small letters: Left_Labi_Nasi is labi_nasi.
std::string sideless(std::string_view name) {
  std::string result = lowered(name);
  for (const std::string_view prefix : {"left_", "right_", "l_", "r_"}) {
    if (result.starts_with(prefix)) return result.substr(prefix.size());
  }
  return result;
}

/// The names that the AU table gives to muscles, each with its spellings in muscle.dat.
std::map<std::string, std::set<std::string>, std::less<>> read_aliases(TableReader& document,
                                                                       Problems& problems) {
  std::map<std::string, std::set<std::string>, std::less<>> aliases;
  const TomlValue* table = document.table_if("muscles");
  if (table == nullptr) return aliases;
  for (const auto& [name, place, value] : table->entries) {
    for (const TomlValue& item : value.items) {
      if (item.kind == TomlValue::Kind::Text) aliases[name].insert(sideless(item.text));
    }
    if (aliases[name].empty()) problems.add(place, name + " must be a list of muscle.dat's names");
  }
  return aliases;
}

Result<void> read_classic_aus(const std::filesystem::path& path, Face& face) {
  const auto document = read_toml(path);
  if (!document) return document.error();
  Problems problems(path.string());
  TableReader reader(*document, problems);
  static_cast<void>(reader.integer("format", 1, 1));
  const auto aliases = read_aliases(reader, problems);
  // Channels that only faces of our own format have: an AU that drives nothing else is mentioned in
  // the remarks and is no error.
  std::vector<std::string> names = {"jaw", "lid_close", "lid_raise"};
  for (const OpposedNames& pair : kOpposedNames) {
    for (const std::string_view name : {pair.plus, pair.minus}) names.emplace_back(name);
  }
  for (const auto& [name, spellings] : aliases) names.push_back(name);
  const auto finder = [&](std::string_view name) {
    std::vector<std::size_t> found = channels_named(face, name);
    const auto spellings = aliases.find(name);
    if (spellings == aliases.end()) return found;
    for (std::size_t i = 0; i < face.muscles.size(); ++i) {
      if (spellings->second.contains(sideless(face.muscles[i].name))) found.push_back(i);
    }
    return found;
  };
  std::vector<int> unknown;
  face.recordings = read_recordings(reader, face, finder, names, problems, &unknown);
  reader.finish();
  if (auto result = problems.result(); !result) return result;
  if (unknown.empty()) return {};
  std::string list;
  for (const int number : unknown) {
    list += (list.empty() ? "" : ", ") + std::to_string(number);
    face.recordings.erase(number);
  }
  face.remarks.push_back("this face has no muscle that shows AU " + list);
  return {};
}

}  // namespace

Result<Face> load_classic_folder(const std::filesystem::path& folder,
                                 const std::filesystem::path& data_folder) {
  Face face;
  face.classic = true;
  face.name = folder.filename().empty() ? folder.parent_path().filename().string()
                                        : folder.filename().string();
  HalfFace half;
  if (auto done = read_points(folder / "faceline.dat", half); !done) return done.error();
  if (auto done = read_rows(folder / "index.dat", half); !done) return done.error();
  build_mesh(half, face);
  if (auto done = read_muscles_dat(folder / "muscle.dat", face); !done) return done.error();
  std::error_code error;
  if (std::filesystem::exists(folder / "jaw.dat", error)) {
    if (auto done = read_jaw_dat(folder / "jaw.dat", half, face); !done) return done.error();
  }
  if (auto done = read_classic_aus(data_folder / "faces" / "classic_aus.toml", face); !done) {
    return done.error();
  }
  return face;
}

}  // namespace aucast::face
