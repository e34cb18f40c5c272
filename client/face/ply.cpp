#include "client/face/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

#include "common/check.h"
#include "common/srgb.h"
#include "common/text.h"

namespace aucast::face {
namespace {

static_assert(std::endian::native == std::endian::little, "mesh files are little-endian");

constexpr std::string_view kCoordinates[] = {"x", "y", "z"};
constexpr std::string_view kColourNames[] = {"red", "green", "blue", "alpha"};
constexpr std::size_t kHeaderBytesMax = 64 * 1024;

/// What a map may hold; a map not listed here is a mask and may hold any finite number.
struct MapRange {
  std::string_view name;
  float low;
  float high;
};
constexpr MapRange kMapRanges[] = {{"muscle", 0, 1},     {"jaw", 0, 1},
                                   {"head", 0, 1},       {"lid_angle", -1.5707964F, 1.5707964F},
                                   {"occlusion", 0, 1},  {"gloss", 0, 4},
                                   {"root_below", -1, 1}};

template <typename T>
T read_at(std::string_view bytes, std::size_t position) {
  T value;
  std::memcpy(&value, bytes.data() + position, sizeof value);
  return value;
}

template <typename T>
void append(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof value);
  bytes.append(raw.data(), raw.size());
}

std::string more_than(std::size_t most, const char* things) {
  return "more than " + std::to_string(most) + " " + things;
}

struct Property {
  std::string name;
  bool is_float = false;
  std::size_t position = 0;  ///< in the vertex' record
};

/// The header, up to `end_header`.
struct Header {
  std::vector<std::pair<std::string, Material>> parts;
  std::vector<Property> properties;
  std::size_t record_bytes = 0;
  std::size_t vertex_count = 0;
  std::size_t polygon_count = 0;
  std::size_t body_begin = 0;

  [[nodiscard]] const Property* find(std::string_view property_name) const {
    const auto found =
        std::find_if(properties.begin(), properties.end(),
                     [&](const Property& property) { return property.name == property_name; });
    return found == properties.end() ? nullptr : &*found;
  }
};

/// Reads the header line by line; `error` is the sentence for the line that was wrong.
class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, std::string_view file) : bytes_(bytes), file_(file) {}

  Result<Header> read() {
    while (!ended_) {
      const std::size_t end = bytes_.substr(0, kHeaderBytesMax).find('\n', position_);
      if (end == std::string_view::npos) return bad("the header does not end with end_header");
      ++line_;
      const std::string_view line = bytes_.substr(position_, end - position_);
      position_ = end + 1;
      if (auto wrong = take_line(split_words(line))) return bad(*wrong);
    }
    if (auto wrong = missing()) return bad(*wrong);
    header_.body_begin = position_;
    return std::move(header_);
  }

 private:
  using Words = std::vector<std::string_view>;
  using Wrong = std::optional<std::string>;
  enum class Element : std::uint8_t { None, Vertex, Face };

  [[nodiscard]] Error bad(const std::string& text) const {
    return {ErrorKind::BadData, at_place(file_, line_, 0, text)};
  }

  Wrong take_line(const Words& words) {
    if (line_ == 1) {
      if (words != Words{"ply"}) return "this is no PLY file: its first line is not 'ply'";
      return std::nullopt;
    }
    if (words.empty() || words[0] == "obj_info") return std::nullopt;
    if (words[0] == "end_header") return ended_ = true, std::nullopt;
    if (words[0] == "comment") return take_comment(words);
    if (words[0] == "format") {
      format_seen_ = words == Words{"format", "binary_little_endian", "1.0"};
      if (!format_seen_) return "the format must be 'binary_little_endian 1.0'";
      return std::nullopt;
    }
    if (words[0] == "element") return take_element(words);
    if (words[0] == "property") return take_property(words);
    return "unknown header line '" + escaped(words[0]) + "'";
  }

  Wrong take_comment(const Words& words) {
    if (words.size() < 2 || words[1] != "part") return std::nullopt;
    if (words.size() != 4) return "a part is written 'comment part NAME MATERIAL'";
    const auto* const found =
        std::find(std::begin(kMaterialNames), std::end(kMaterialNames), words[3]);
    if (found == std::end(kMaterialNames)) {
      const std::vector<std::string> known(std::begin(kMaterialNames), std::end(kMaterialNames));
      return "unknown material '" + escaped(words[3]) + "'" + did_you_mean(words[3], known);
    }
    for (const auto& [part_name, material] : header_.parts) {
      if (part_name == words[2]) return "part '" + escaped(words[2]) + "' is there twice";
    }
    if (header_.parts.empty() && words[2] != "skin") return "the first part must be skin";
    if (header_.parts.size() == kPlyPartsMax) return more_than(kPlyPartsMax, "parts");
    header_.parts.emplace_back(words[2], static_cast<Material>(found - std::begin(kMaterialNames)));
    return std::nullopt;
  }

  Wrong take_element(const Words& words) {
    std::size_t count = 0;
    if (words.size() == 3) {
      const auto [end, code] =
          std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
      if (code != std::errc() || end != words[2].data() + words[2].size()) {
        return "'" + escaped(words[2]) + "' is no count";
      }
      if (words[1] == "vertex" && element_ == Element::None) {
        if (count > kPlyVerticesMax) return more_than(kPlyVerticesMax, "vertices");
        header_.vertex_count = count;
        return element_ = Element::Vertex, std::nullopt;
      }
      if (words[1] == "face" && element_ == Element::Vertex) {
        if (count > kPlyPolygonsMax) return more_than(kPlyPolygonsMax, "polygons");
        header_.polygon_count = count;
        return element_ = Element::Face, std::nullopt;
      }
    }
    return "the elements must be 'vertex N' and then 'face N', once each";
  }

  Wrong take_property(const Words& words) {
    if (element_ == Element::Face) {
      const bool known = words.size() == 5 && words[1] == "list" &&
                         (words[2] == "uchar" || words[2] == "uint8") &&
                         (words[3] == "uint" || words[3] == "uint32" || words[3] == "int" ||
                          words[3] == "int32") &&
                         (words[4] == "vertex_indices" || words[4] == "vertex_index");
      if (!known || list_seen_) {
        return "faces have exactly the property 'list uchar uint vertex_indices'";
      }
      return list_seen_ = true, std::nullopt;
    }
    if (element_ == Element::None || words.size() != 3) return "this property is not understood";
    const bool is_float = words[1] == "float" || words[1] == "float32";
    const bool is_byte = words[1] == "uchar" || words[1] == "uint8";
    const std::string property_name(words[2]);
    const bool byte_needed =
        property_name == "part" || std::find(std::begin(kColourNames), std::end(kColourNames),
                                             property_name) != std::end(kColourNames);
    if (byte_needed ? !is_byte : !is_float) {
      return "property " + escaped(property_name) + " must be " + (byte_needed ? "uchar" : "float");
    }
    if (header_.find(property_name) != nullptr) {
      return "property " + escaped(property_name) + " is there twice";
    }
    if (header_.properties.size() == kPlyPropertiesMax) {
      return more_than(kPlyPropertiesMax, "properties");
    }
    header_.properties.push_back({property_name, is_float, header_.record_bytes});
    header_.record_bytes += is_float ? sizeof(float) : 1;
    return std::nullopt;
  }

  [[nodiscard]] Wrong missing() const {
    if (!format_seen_) return "there is no format line";
    if (element_ != Element::Face || !list_seen_) {
      return "the elements vertex and face with their properties must come before end_header";
    }
    for (const std::string_view needed : {"x", "y", "z", "red", "green", "blue", "alpha", "part"}) {
      if (header_.find(needed) == nullptr) {
        return "vertices have no property " + std::string(needed);
      }
    }
    if (header_.parts.empty()) return "no part is named: 'comment part skin skin' is needed";
    return std::nullopt;
  }

  std::string_view bytes_;
  std::string_view file_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  Header header_;
  Element element_ = Element::None;
  bool ended_ = false;
  bool format_seen_ = false;
  bool list_seen_ = false;
};

bool is_coordinate(std::string_view property_name) {
  return std::find(std::begin(kCoordinates), std::end(kCoordinates), property_name) !=
         std::end(kCoordinates);
}

/// Reads vertices and polygons after the header.
class BodyReader {
 public:
  BodyReader(std::string_view bytes, std::string_view file, const Header& header)
      : bytes_(bytes), file_(file), header_(header) {}

  Result<FaceMesh> read() {
    const std::size_t vertex_bytes = header_.vertex_count * header_.record_bytes;
    if (bytes_.size() - header_.body_begin < vertex_bytes) {
      return bad("the file ends before its " + std::to_string(header_.vertex_count) + " vertices");
    }
    if (auto done = read_positions(); !done) return done.error();
    if (auto done = read_parts(); !done) return done.error();
    read_colours();
    if (auto done = read_maps(); !done) return done.error();
    if (auto done = read_polygons(header_.body_begin + vertex_bytes); !done) return done.error();
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] Error bad(const std::string& text) const {
    return {ErrorKind::BadData, at_place(file_, text)};
  }

  template <typename T>
  [[nodiscard]] T vertex_value(std::size_t vertex, const Property& property) const {
    return read_at<T>(bytes_,
                      header_.body_begin + vertex * header_.record_bytes + property.position);
  }

  Result<void> read_positions() {
    mesh_.positions.resize(header_.vertex_count);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view axis_name = kCoordinates[axis];
      const Property& property = *header_.find(axis_name);
      for (std::size_t i = 0; i < header_.vertex_count; ++i) {
        const float value = vertex_value<float>(i, property);
        if (!std::isfinite(value)) {
          return bad("vertex " + std::to_string(i) + ": " + std::string(axis_name) +
                     " is not a finite number");
        }
        mesh_.positions[i][axis] = value;
      }
    }
    return {};
  }

  Result<void> read_parts() {
    for (const auto& [part_name, material] : header_.parts) {
      mesh_.parts.push_back({part_name, material, 0, 0, 0, 0});
    }
    const Property& property = *header_.find("part");
    std::size_t current = 0;
    for (std::size_t i = 0; i < header_.vertex_count; ++i) {
      const std::size_t part = vertex_value<std::uint8_t>(i, property);
      if (part >= mesh_.parts.size()) {
        return bad("vertex " + std::to_string(i) + ": there is no part " + std::to_string(part));
      }
      if (part < current) {
        return bad("vertex " + std::to_string(i) + ": the vertices of part " +
                   mesh_.parts[part].name + " do not stand together in the parts' order");
      }
      if (mesh_.parts[part].vertex_count == 0) {
        mesh_.parts[part].vertex_begin = static_cast<std::uint32_t>(i);
      }
      ++mesh_.parts[part].vertex_count;
      current = part;
    }
    for (const MeshPart& part : mesh_.parts) {
      if (part.vertex_count == 0) return bad("part " + escaped(part.name) + " has no vertices");
    }
    return {};
  }

  void read_colours() {
    mesh_.colours.resize(header_.vertex_count);
    for (int channel = 0; channel < 4; ++channel) {
      const Property& property = *header_.find(kColourNames[channel]);
      for (std::size_t i = 0; i < header_.vertex_count; ++i) {
        const auto byte = vertex_value<std::uint8_t>(i, property);
        mesh_.colours[i][channel] =
            channel == 3 ? static_cast<float>(byte) / 255.0F : linear_of_srgb(byte);
      }
    }
  }

  Result<void> read_maps() {
    mesh_.occlusion.assign(header_.vertex_count, 1.0F);
    mesh_.gloss.assign(header_.vertex_count, 1.0F);
    for (const Property& property : header_.properties) {
      if (!property.is_float || is_coordinate(property.name)) continue;
      const auto* const range =
          std::find_if(std::begin(kMapRanges), std::end(kMapRanges),
                       [&](const MapRange& known) { return known.name == property.name; });
      std::vector<float> map(header_.vertex_count);
      for (std::size_t i = 0; i < map.size(); ++i) {
        map[i] = vertex_value<float>(i, property);
        // The place costs more than the reading: only for an error.
        const auto place = [&] {
          return "vertex " + std::to_string(i) + ": " + escaped(property.name);
        };
        if (!std::isfinite(map[i])) return bad(place() + " is not a finite number");
        if (range != std::end(kMapRanges) && (map[i] < range->low || map[i] > range->high)) {
          return bad(place() + " is " + std::to_string(map[i]) + ", outside " +
                     std::to_string(range->low) + " to " + std::to_string(range->high));
        }
      }
      if (property.name == "occlusion") {
        mesh_.occlusion = std::move(map);
      } else if (property.name == "gloss") {
        mesh_.gloss = std::move(map);
      } else {
        mesh_.maps.emplace(property.name, std::move(map));
      }
    }
    return {};
  }

  [[nodiscard]] std::size_t part_of(std::uint32_t vertex) const {
    std::size_t part = mesh_.parts.size() - 1;
    while (mesh_.parts[part].vertex_begin > vertex) --part;
    return part;
  }

  Result<void> read_polygons(std::size_t position) {
    std::vector<std::vector<std::array<std::uint32_t, 3>>> by_part(mesh_.parts.size());
    for (std::size_t i = 0; i < header_.polygon_count; ++i) {
      const auto place = [i] { return "polygon " + std::to_string(i) + ": "; };
      if (position >= bytes_.size()) return bad(place() + "the file ends here");
      const auto count = read_at<std::uint8_t>(bytes_, position++);
      if (count != 3 && count != 4) {
        return bad(place() + "it has " + std::to_string(count) + " corners, not 3 or 4");
      }
      if (bytes_.size() - position < count * sizeof(std::uint32_t)) {
        return bad(place() + "the file ends here");
      }
      std::array<std::uint32_t, 4> corners{};
      std::memcpy(corners.data(), bytes_.data() + position, count * sizeof(std::uint32_t));
      position += count * sizeof(std::uint32_t);
      for (std::size_t k = 0; k < count; ++k) {
        if (corners[k] >= header_.vertex_count) {
          return bad(place() + "there is no vertex " + std::to_string(corners[k]));
        }
        if (part_of(corners[k]) != part_of(corners[0])) {
          return bad(place() + "it joins the parts " + mesh_.parts[part_of(corners[0])].name +
                     " and " + mesh_.parts[part_of(corners[k])].name);
        }
      }
      auto& triangles = by_part[part_of(corners[0])];
      triangles.push_back({corners[0], corners[1], corners[2]});
      if (count == 4) triangles.push_back({corners[0], corners[2], corners[3]});
    }
    if (position != bytes_.size()) return bad("there are bytes after the last polygon");
    for (std::size_t part = 0; part < by_part.size(); ++part) {
      mesh_.parts[part].triangle_begin = static_cast<std::uint32_t>(mesh_.triangles.size());
      mesh_.parts[part].triangle_count = static_cast<std::uint32_t>(by_part[part].size());
      mesh_.triangles.insert(mesh_.triangles.end(), by_part[part].begin(), by_part[part].end());
    }
    return {};
  }

  std::string_view bytes_;
  std::string_view file_;
  const Header& header_;
  FaceMesh mesh_;
};

void check_sound(const FaceMesh& mesh) {
  const std::size_t count = mesh.positions.size();
  AUCAST_CHECK(mesh.colours.size() == count);
  AUCAST_CHECK(mesh.occlusion.empty() || mesh.occlusion.size() == count);
  AUCAST_CHECK(mesh.gloss.empty() || mesh.gloss.size() == count);
  for (const auto& [map_name, map] : mesh.maps) AUCAST_CHECK(map.size() == count);
  AUCAST_CHECK(mesh.parts.size() <= kPlyPartsMax);
  std::size_t covered = 0;
  for (const MeshPart& part : mesh.parts) {
    AUCAST_CHECK(part.vertex_begin == covered);
    covered += part.vertex_count;
  }
  AUCAST_CHECK(covered == count);
}

}  // namespace

Result<FaceMesh> parse_ply(std::string_view bytes, std::string_view file) {
  auto header = HeaderReader(bytes, file).read();
  if (!header) return header.error();
  return BodyReader(bytes, file, *header).read();
}

std::string format_ply(const FaceMesh& mesh, std::span<const Polygon> polygons) {
  check_sound(mesh);
  std::vector<std::pair<std::string_view, const std::vector<float>*>> maps;
  if (!mesh.occlusion.empty()) maps.emplace_back("occlusion", &mesh.occlusion);
  if (!mesh.gloss.empty()) maps.emplace_back("gloss", &mesh.gloss);
  for (const auto& [map_name, map] : mesh.maps) maps.emplace_back(map_name, &map);

  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  for (const MeshPart& part : mesh.parts) {
    bytes += "comment part " + part.name + " " + std::string(name(part.material)) + "\n";
  }
  bytes += "element vertex " + std::to_string(mesh.positions.size()) + "\n";
  for (const auto& coordinate : kCoordinates) {
    bytes += "property float " + std::string(coordinate) + "\n";
  }
  for (const auto& colour : kColourNames) bytes += "property uchar " + std::string(colour) + "\n";
  bytes += "property uchar part\n";
  for (const auto& [map_name, map] : maps)
    bytes += "property float " + std::string(map_name) + "\n";
  bytes += "element face " + std::to_string(polygons.size()) +
           "\nproperty list uchar uint vertex_indices\nend_header\n";

  for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
    for (std::size_t k = 0; k < mesh.parts[part].vertex_count; ++k) {
      const std::size_t i = mesh.parts[part].vertex_begin + k;
      for (int axis = 0; axis < 3; ++axis) append(bytes, mesh.positions[i][axis]);
      for (int c = 0; c < 3; ++c) append(bytes, srgb_of_linear(mesh.colours[i][c]));
      append(bytes, byte_of_share(mesh.colours[i][3]));
      append(bytes, static_cast<std::uint8_t>(part));
      for (const auto& [map_name, map] : maps) append(bytes, (*map)[i]);
    }
  }
  for (const Polygon& polygon : polygons) {
    AUCAST_CHECK(polygon.corner_count == 3 || polygon.corner_count == 4);
    append(bytes, polygon.corner_count);
    for (std::size_t k = 0; k < polygon.corner_count; ++k) append(bytes, polygon.corners[k]);
  }
  return bytes;
}

}  // namespace aucast::face
