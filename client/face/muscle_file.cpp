#include "client/face/muscle_file.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "client/face/toml_points.h"
#include "common/action_unit.h"
#include "common/text.h"

namespace aucast::face {
namespace {

void check_ends(TableReader& reader, const glm::vec3& attachment, const glm::vec3& insertion) {
  if (attachment == insertion) reader.wrong("insertion", "must differ from the attachment");
}

/// Z of the sphincters: the way is divided by it, and its sign says where to.
float divisor(TableReader& reader, std::string_view key, float fallback) {
  const float value = reader.number_or(key, fallback);
  if (std::abs(value) < 1) reader.wrong(key, "must be at least 1, or at most -1");
  return value;
}

LinearMuscle read_linear(TableReader& reader) {
  LinearMuscle muscle;
  muscle.attachment = read_point(reader, "attachment");
  muscle.insertion = read_point(reader, "insertion");
  check_ends(reader, muscle.attachment, muscle.insertion);
  muscle.zone_rad = kRadPerDeg * reader.number("zone_deg", Bounds::inside(0, 90));
  muscle.falloff_start = reader.number("falloff_start", {.low = 0});
  muscle.falloff_finish = reader.number("falloff_finish", Bounds::above(0));
  if (muscle.falloff_finish <= muscle.falloff_start) {
    reader.wrong("falloff_finish", "must be above falloff_start");
  }
  muscle.cap = reader.number_or("cap", 0.95F, {.low = 0, .high = 1, .low_open = true});
  return muscle;
}

MouthSphincter read_mouth(TableReader& reader) {
  MouthSphincter muscle;
  muscle.centre = read_point(reader, "centre");
  muscle.semi_axes = read_pair(reader, "semi_axes", Bounds::above(0));
  if (muscle.semi_axes.x < muscle.semi_axes.y) {
    reader.wrong("semi_axes", "must have the longer one first");
  }
  muscle.depth = reader.number("depth", Bounds::above(0));
  muscle.protrusion = divisor(reader, "protrusion", muscle.protrusion);
  return muscle;
}

EyeSphincter read_eye(TableReader& reader) {
  EyeSphincter muscle;
  muscle.centre = read_point(reader, "centre");
  muscle.semi_axes = read_pair(reader, "semi_axes", Bounds::above(0));
  muscle.depth = reader.number("depth", Bounds::above(0));
  muscle.bulge = divisor(reader, "bulge", muscle.bulge);
  muscle.upper_share = reader.number_or("upper_share", muscle.upper_share, Bounds::between(0, 1));
  muscle.lower_share = reader.number_or("lower_share", muscle.lower_share, Bounds::between(0, 1));
  return muscle;
}

SheetMuscle read_sheet(TableReader& reader) {
  SheetMuscle muscle;
  muscle.attachment = read_point(reader, "attachment");
  muscle.insertion = read_point(reader, "insertion");
  check_ends(reader, muscle.attachment, muscle.insertion);
  muscle.width = reader.number("width", Bounds::above(0));
  muscle.peak = reader.number_or("peak", muscle.peak, Bounds::inside(0, 1));
  muscle.depth = reader.number("depth", Bounds::above(0));
  return muscle;
}

LocalPull read_pull(TableReader& reader) {
  LocalPull muscle;
  muscle.centre = read_point(reader, "centre");
  muscle.direction = read_point(reader, "direction");
  if (muscle.direction == glm::vec3(0)) reader.wrong("direction", "must not be zero");
  muscle.radii = read_point(reader, "radii", Bounds::above(0));
  return muscle;
}

MuscleShape read_shape(TableReader& reader) {
  const std::string kind = reader.text("kind");
  if (kind == "linear") return read_linear(reader);
  if (kind == "mouth_sphincter") return read_mouth(reader);
  if (kind == "eye_sphincter") return read_eye(reader);
  if (kind == "sheet") return read_sheet(reader);
  if (kind == "pull") return read_pull(reader);
  reader.wrong("kind", "'" + escaped(kind) + "' is unknown" +
                           did_you_mean(kind, {"linear", "mouth_sphincter", "eye_sphincter",
                                               "sheet", "pull"}));
  return LinearMuscle{};
}

bool good_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::string read_mask(TableReader& reader, const FaceMesh& mesh) {
  std::string mask = reader.text_or("mask", "");
  if (mask.empty() || mesh.maps.contains(mask)) return mask;
  std::vector<std::string> known;
  for (const auto& [name, map] : mesh.maps) known.push_back(name);
  reader.wrong("mask", "'" + escaped(mask) + "' is no map of the mesh" + did_you_mean(mask, known));
  return {};
}

struct MirrorInPlace {
  void operator()(LinearMuscle& m) const { flip(m.attachment), flip(m.insertion); }
  void operator()(MouthSphincter& m) const { flip(m.centre); }
  void operator()(EyeSphincter& m) const { flip(m.centre); }
  void operator()(SheetMuscle& m) const { flip(m.attachment), flip(m.insertion); }
  void operator()(LocalPull& m) const { flip(m.centre), flip(m.direction); }
  static void flip(glm::vec3& v) { v.x = -v.x; }
};

struct XOf {
  float operator()(const LinearMuscle& m) const { return m.insertion.x; }
  float operator()(const SheetMuscle& m) const { return m.insertion.x; }
  template <typename Centred>
  float operator()(const Centred& m) const {
    return m.centre.x;
  }
};

}  // namespace

float x_of(const MuscleShape& shape) {
  return std::visit(XOf{}, shape);
}

MuscleShape mirrored(MuscleShape shape) {
  std::visit(MirrorInPlace{}, shape);
  return shape;
}

std::vector<Muscle> read_muscles(TableReader& document, const FaceMesh& mesh, Problems& problems) {
  std::vector<Muscle> muscles;
  std::set<std::string, std::less<>> names;
  for (const TomlValue* table : document.tables("muscle")) {
    TableReader reader(*table, problems);
    const std::string name = reader.text("name");
    if (!good_name(name)) reader.wrong("name", "must be made of letters, digits and _");
    const bool both_sides = reader.boolean_or("mirrored", false);
    Muscle muscle{name, read_shape(reader), read_mask(reader, mesh)};
    muscle.mask_alone = reader.boolean_or("mask_alone", false);
    if (muscle.mask_alone && muscle.mask.empty()) reader.wrong("mask_alone", "needs a mask");
    muscle.yields_to_lids = reader.boolean_or("yields_to_lids", false);
    muscle.activation_max = reader.number_or("activation_max", kMuscleMax,
                                             {.low = 0, .high = kMuscleMax, .low_open = true});
    reader.finish();
    if (both_sides && !(x_of(muscle.shape) > 0)) {
      reader.wrong("mirrored", "needs the insertion or centre at x > 0, the left side");
    }
    for (const Side side : {Side::Left, Side::Right}) {
      if (both_sides) muscle.name = sided_name(side, name);
      if (side == Side::Right) {
        if (!both_sides) break;
        muscle.shape = mirrored(muscle.shape);
      }
      if (!names.insert(muscle.name).second) {
        reader.wrong("name", "'" + muscle.name + "' is there twice");
      }
      muscles.push_back(muscle);
    }
  }
  return muscles;
}

}  // namespace aucast::face
