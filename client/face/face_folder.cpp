#include "client/face/face_folder.h"

#include <algorithm>
#include <set>
#include <utility>

#include "client/face/au_recordings.h"
#include "client/face/muscle_file.h"
#include "client/face/opposed_channels.h"
#include "client/face/ply.h"
#include "client/face/toml_points.h"
#include "common/files.h"
#include "common/text.h"

namespace aucast::face {
namespace {

constexpr float kJawMax = 4;
/// Further, hair would go through the face, whatever the face.
constexpr float kSwingDegMax = 15;

Jaw read_jaw(const TomlValue& table, Problems& problems) {
  TableReader reader(table, problems);
  Jaw jaw;
  jaw.hinge = read_point(reader, "hinge");
  jaw.degrees_per_unit =
      reader.number("degrees_per_unit", {.low = 0, .high = 90 / kJawMax, .low_open = true});
  jaw.forward_per_rad = reader.number_or("forward_per_rad", 0, Bounds::between(-10, 10));
  reader.finish();
  return jaw;
}

Eye read_eye(const TomlValue& table, Problems& problems) {
  TableReader reader(table, problems);
  Eye eye;
  eye.part = reader.text("part");
  eye.centre = read_point(reader, "centre");
  eye.yaw_deg = reader.number_or("yaw_deg", eye.yaw_deg, Bounds::between(0, 90));
  eye.pitch_deg = reader.number_or("pitch_deg", eye.pitch_deg, Bounds::between(0, 90));
  reader.finish();
  return eye;
}

HeadPose read_head(const TomlValue& table, Problems& problems) {
  TableReader reader(table, problems);
  HeadPose head;
  head.pivot = read_point(reader, "pivot");
  head.turn_deg = reader.number_or("turn_deg", head.turn_deg, Bounds::between(0, 90));
  head.pitch_deg = reader.number_or("pitch_deg", head.pitch_deg, Bounds::between(0, 90));
  head.tilt_deg = reader.number_or("tilt_deg", head.tilt_deg, Bounds::between(0, 90));
  head.shift = reader.number_or("shift", head.shift, Bounds::between(0, 10));
  reader.finish();
  return head;
}

Hair read_hair(const TomlValue& table, Problems& problems) {
  TableReader reader(table, problems);
  Hair hair;
  hair.hinge = read_point(reader, "hinge");
  hair.swing_deg = reader.number_or("swing_deg", hair.swing_deg, Bounds::between(0, kSwingDegMax));
  reader.finish();
  return hair;
}

void need_map(const FaceMesh& mesh, std::string_view map, LinePosition place, Problems& problems) {
  if (mesh.maps.contains(std::string(map))) return;
  problems.add(place, "this needs the map '" + std::string(map) + "', which the mesh lacks");
}

/// Everything in face.toml itself, without the files that it names.
void read_movers(TableReader& reader, Face& face, Problems& problems) {
  for (const TomlValue* table : reader.tables("eye")) {
    const Eye eye = read_eye(*table, problems);
    const auto is_part = [&](const MeshPart& part) { return part.name == eye.part; };
    if (std::none_of(face.mesh.parts.begin(), face.mesh.parts.end(), is_part)) {
      std::vector<std::string> known;
      for (const MeshPart& part : face.mesh.parts) known.push_back(part.name);
      TableReader(*table, problems)
          .wrong("part", "'" + escaped(eye.part) + "' is no part of the mesh" +
                             did_you_mean(eye.part, known));
    }
    for (const Eye& other : face.eyes) {
      if (side_at(other.centre.x) == side_at(eye.centre.x)) {
        problems.add(table->place, "there are two eyes on one side");
      } else if (other.part == eye.part) {
        problems.add(table->place, "the two eyes are one part of the mesh: each turns its own");
      }
    }
    face.eyes.push_back(eye);
  }
  std::stable_sort(face.eyes.begin(), face.eyes.end(),
                   [](const Eye& a, const Eye& b) { return a.centre.x > b.centre.x; });
  if (const TomlValue* table = reader.table_if("jaw")) {
    face.jaw = read_jaw(*table, problems);
    need_map(face.mesh, "jaw", table->place, problems);
  }
  if (const TomlValue* table = reader.table_if("lids")) {
    TableReader lids(*table, problems);
    face.lids = Lids{lids.number_or("raise_max", Lids{}.raise_max, Bounds::between(0, 1))};
    lids.finish();
    need_map(face.mesh, "lid_angle", table->place, problems);
    if (face.eyes.empty()) problems.add(table->place, "lids need an [[eye]] to turn about");
  }
  if (const TomlValue* table = reader.table_if("head")) {
    face.head = read_head(*table, problems);
    need_map(face.mesh, "head", table->place, problems);
  }
  if (const TomlValue* table = reader.table_if("hair")) {
    face.hair = read_hair(*table, problems);
    if (!face.head) problems.add(table->place, "hair needs a [head] to swing after");
  }
}

/// Where a part lies by the mean of its vertices.
Side side_of(const MeshPart& part, const FaceMesh& mesh) {
  float sum = 0;
  for (std::uint32_t i = 0; i < part.vertex_count; ++i) {
    sum += mesh.positions[part.vertex_begin + i].x;
  }
  return side_at(part.vertex_count > 0 ? sum / static_cast<float>(part.vertex_count) : 0);
}

/// The channels in the order that face.h documents.
std::vector<Channel> channels_of(const Face& face) {
  std::vector<Channel> channels;
  for (const Muscle& muscle : face.muscles) {
    channels.push_back({muscle.name, side_at(x_of(muscle.shape)), muscle.activation_max});
  }
  if (face.jaw) channels.push_back({"jaw", Side::Both, kJawMax});
  const auto add_for_eyes = [&](std::string_view name) {
    for (const Eye& eye : face.eyes) {
      const Side side = side_at(eye.centre.x);
      channels.push_back({sided_name(side, name), side, 1, name == "lid_close"});
    }
  };
  if (face.lids) {
    add_for_eyes("lid_close");
    add_for_eyes("lid_raise");
  }
  const auto add_opposed = [&](const OpposedNames& pair, Side side) {
    for (const std::string_view name : {pair.plus, pair.minus}) {
      channels.push_back({sided_name(side, name), side, 1});
    }
  };
  for (const Eye& eye : face.eyes) {
    for (const OpposedNames& pair : {kGazeYaw, kGazePitch}) {
      add_opposed(pair, side_at(eye.centre.x));
    }
  }
  if (face.head) {
    for (const OpposedNames& pair : {kHeadTurn, kHeadPitch, kHeadTilt, kHeadShift}) {
      add_opposed(pair, Side::Both);
    }
  }
  for (const MeshPart& part : face.mesh.parts) {
    if (!is_crease(part)) continue;
    channels.push_back({part.name, side_of(part, face.mesh), 1});
  }
  return channels;
}

/// Which lines the skin keeps, by their names with or without a side.
void read_kept_lines(const TomlValue& table, Face& face, Problems& problems) {
  TableReader lines(table, problems);
  for (const MeshPart& part : face.mesh.parts) {
    const auto channel = is_crease(part) ? face.channel_index(part.name) : std::nullopt;
    if (!channel) continue;
    for (const std::string_view name : {split_side(part.name).base, std::string_view(part.name)}) {
      float& kept = face.channels[*channel].kept;
      kept = lines.number_or(name, kept, Bounds::between(0, 1));
    }
  }
  lines.finish();
}

/// The names that an AU table may use, for "did you mean".
std::vector<std::string> drive_names(const Face& face) {
  std::set<std::string> names;
  for (const Channel& channel : face.channels) {
    names.insert(channel.name);
    names.emplace(split_side(channel.name).base);
  }
  return {names.begin(), names.end()};
}

Result<void> load_mesh(const std::filesystem::path& path, Face& face) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  auto mesh = parse_ply(*bytes, path.string());
  if (!mesh) return mesh.error();
  face.mesh = std::move(*mesh);
  return {};
}

Result<void> load_muscles(const std::filesystem::path& path, Face& face) {
  const auto document = read_toml(path);
  if (!document) return document.error();
  Problems problems(path.string());
  TableReader reader(*document, problems);
  face.muscles = read_muscles(reader, face.mesh, problems);
  reader.finish();
  return problems.result();
}

/// Neither a muscle nor a crease of the mesh may take the name of another channel, such as jaw.
Result<void> check_channel_names(const Face& face, const std::filesystem::path& muscles,
                                 const std::filesystem::path& mesh) {
  std::set<std::string_view> names;
  for (const Channel& channel : face.channels) {
    if (names.insert(channel.name).second) continue;
    const bool crease = std::any_of(
        face.mesh.parts.begin(), face.mesh.parts.end(),
        [&](const MeshPart& part) { return is_crease(part) && part.name == channel.name; });
    return Error{ErrorKind::BadData,
                 at_place((crease ? mesh : muscles).string(), 0, 0,
                          std::string(crease ? "the name of the crease '" : "the muscle name '") +
                              escaped(channel.name) + "' is taken: it is a channel of its own")};
  }
  return {};
}

/// Adds to the error about a missing file that it belongs to another face, for users who copied
/// only this one.
Error with_owner(Error error, const std::filesystem::path& file) {
  const std::filesystem::path plain = file.lexically_normal();
  if (error.kind != ErrorKind::Unreadable || plain.empty() || *plain.begin() != "..") return error;
  error.message += "; this face shares it with " +
                   printable(plain.parent_path().filename().string()) +
                   ", which belongs beside it: copy both";
  return error;
}

}  // namespace

Result<AuRecordings> load_aus(const std::filesystem::path& path, const Face& face) {
  const auto document = read_toml(path);
  if (!document) return document.error();
  Problems problems(path.string());
  TableReader reader(*document, problems);
  const auto finder = [&face](std::string_view name) { return channels_named(face, name); };
  AuRecordings recordings = read_recordings(reader, face, finder, drive_names(face), problems);
  reader.finish();
  if (auto read = problems.result(); !read) return read.error();
  return recordings;
}

Result<Face> load_face_folder(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kFaceFile;
  const auto document = read_toml(path);
  if (!document) return document.error();
  Problems problems(path.string());
  TableReader reader(*document, problems);
  static_cast<void>(reader.integer("format", 1, 1));
  Face face;
  face.name = reader.text("name");
  face.copy_of = reader.text_or("copy_of", "");
  const std::string mesh_file = reader.text("mesh");
  const std::string muscles_file = reader.text("muscles");
  const std::string aus_file = reader.text("aus");
  if (auto result = problems.result(); !result) return result.error();
  if (auto loaded = load_mesh(folder / mesh_file, face); !loaded) {
    return with_owner(loaded.error(), mesh_file);
  }
  read_movers(reader, face, problems);
  const TomlValue* const kept_lines = reader.table_if("lines");
  reader.finish();
  if (auto result = problems.result(); !result) return result.error();
  if (auto loaded = load_muscles(folder / muscles_file, face); !loaded) {
    return with_owner(loaded.error(), muscles_file);
  }
  face.channels = channels_of(face);
  auto named = check_channel_names(face, folder / muscles_file, folder / mesh_file);
  if (!named) return named.error();
  if (kept_lines != nullptr) read_kept_lines(*kept_lines, face, problems);
  if (auto result = problems.result(); !result) return result.error();
  auto recordings = load_aus(folder / aus_file, face);
  if (!recordings) return with_owner(recordings.error(), aus_file);
  face.recordings = std::move(*recordings);
  return face;
}

}  // namespace aucast::face
