#include "client/glb/glb_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include <glm/common.hpp>

#include "common/check.h"

namespace aucast::glb {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// Numbers of the specification.
constexpr int kByte = 5120;
constexpr int kUnsignedByte = 5121;
constexpr int kShort = 5122;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kNoTarget = 0;
constexpr int kVertexTarget = 34962;
constexpr int kIndexTarget = 34963;
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// The largest number of 16 bits may not be an index: it ends a strip.
constexpr std::size_t kShortVerticesMax = 65'535;

constexpr float kShortMax = 65'535;

/// The whole number that stands for `value`, a share of the largest one; a float stands for itself.
template <typename T>
T stored(float value) {
  if constexpr (std::is_floating_point_v<T>) {
    return value;
  } else {
    return static_cast<T>(
        std::lround(std::numeric_limits<T>::max() * std::clamp(value, -1.0F, 1.0F)));
  }
}

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void pad(std::string& bytes, char with) {
  bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

template <typename T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void set_range(Json& accessor, const glm::vec3& low, const glm::vec3& high) {
  accessor["min"] = vector_of(low);
  accessor["max"] = vector_of(high);
}

}  // namespace

Json vector_of(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

glm::vec3 stored_position_change(const glm::vec3& metres) {
  glm::vec3 change = metres;
  for (glm::length_t i = 0; i < change.length(); ++i) {
    change[i] = static_cast<float>(stored<std::int16_t>(metres[i])) /
                std::numeric_limits<std::int16_t>::max();
  }
  return change;
}

GlbFile::GlbFile() {
  document_["asset"] = {{"version", "2.0"}};
}

int GlbFile::view(std::string_view bytes, int target) {
  pad(binary_, '\0');
  Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != kNoTarget) view["target"] = target;
  binary_ += bytes;
  views_.push_back(std::move(view));
  return static_cast<int>(views_.size()) - 1;
}

int GlbFile::accessor(int view, int component, std::string_view type, std::size_t count) {
  accessors_.push_back(
      {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return static_cast<int>(accessors_.size()) - 1;
}

template <typename T>
int GlbFile::vertices(std::span<const T> values, int component, std::string_view type) {
  return accessor(view(bytes_of(values), kVertexTarget), component, type, values.size());
}

/// Whole numbers that stand for shares of their largest one.
int GlbFile::shares(std::span<const std::array<std::uint16_t, 4>> shorts) {
  const int index = vertices(shorts, kUnsignedShort, "VEC4");
  accessors_.back()["normalized"] = true;
  return index;
}

/// Numbers that belong to no vertex.
template <typename T>
int GlbFile::floats(std::span<const T> values, std::string_view type) {
  return accessor(view(bytes_of(values), kNoTarget), kFloat, type, values.size());
}

int GlbFile::positions(std::span<const glm::vec3> positions) {
  AUCAST_CHECK(!positions.empty());
  glm::vec3 low = positions.front();
  glm::vec3 high = positions.front();
  for (const glm::vec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  const int index = vertices(positions, kFloat, "VEC3");
  set_range(accessors_.back(), low, high);
  return index;
}

int GlbFile::normals(std::span<const glm::vec3> normals) {
  return vertices(normals, kFloat, "VEC3");
}

int GlbFile::colours(std::span<const glm::vec4> colours) {
  std::vector<std::array<std::uint16_t, 4>> shorts;
  for (const glm::vec4& colour : colours) {
    auto& one = shorts.emplace_back();
    for (glm::length_t i = 0; i < 4; ++i) {
      one[static_cast<std::size_t>(i)] =
          static_cast<std::uint16_t>(std::lround(kShortMax * std::clamp(colour[i], 0.0F, 1.0F)));
    }
  }
  return shares(shorts);
}

int GlbFile::texture_coordinates(std::span<const glm::vec2> coordinates) {
  return vertices(coordinates, kFloat, "VEC2");
}

int GlbFile::joints(std::span<const std::array<std::uint8_t, 4>> joints) {
  return vertices(joints, kUnsignedByte, "VEC4");
}

int GlbFile::joint_weights(std::span<const std::array<float, 4>> weights) {
  std::vector<std::array<std::uint16_t, 4>> shorts;
  for (const std::array<float, 4>& given : weights) {
    auto& one = shorts.emplace_back();
    int left = static_cast<int>(kShortMax);
    for (std::size_t i = 0; i < given.size(); ++i) {
      one[i] = static_cast<std::uint16_t>(std::lround(kShortMax * given[i]));
      left -= one[i];
    }
    auto& largest = *std::max_element(one.begin(), one.end());
    largest = static_cast<std::uint16_t>(largest + left);
  }
  return shares(shorts);
}

int GlbFile::triangles(std::span<const std::array<std::uint32_t, 3>> triangles,
                       std::size_t vertex_count) {
  if (vertex_count > kShortVerticesMax) {
    return accessor(view(bytes_of(triangles), kIndexTarget), kUnsignedInt, "SCALAR",
                    3 * triangles.size());
  }
  std::vector<std::uint16_t> shorts;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t i : triangle) shorts.push_back(static_cast<std::uint16_t>(i));
  }
  return accessor(view(bytes_of(std::span<const std::uint16_t>(shorts)), kIndexTarget),
                  kUnsignedShort, "SCALAR", shorts.size());
}

int GlbFile::inverse_bind_matrices(std::span<const std::array<float, 16>> matrices) {
  return floats(matrices, "MAT4");
}

/// Without a view the accessor is all zeros, which is what most targets change of most meshes:
/// there is one for all of them.
template <typename T>
int GlbFile::changes(std::span<const Change> changes, std::size_t vertex_count, int component,
                     int width) {
  const int index = static_cast<int>(accessors_.size());
  if (changes.empty()) {
    const auto [known, first] = zeros_.try_emplace({component, vertex_count}, index);
    if (!first) return known->second;
  }
  Json accessor{{"componentType", component},
                {"count", vertex_count},
                {"type", width == 4 ? "VEC4" : "VEC3"}};
  if (std::is_integral_v<T>) accessor["normalized"] = true;
  const bool wide = vertex_count > kShortVerticesMax;
  if (!changes.empty()) {
    const auto aligned = [](std::string& bytes, std::size_t step) {
      bytes.resize((bytes.size() + step - 1) / step * step);
      return bytes.size();
    };
    const std::size_t vertices =
        aligned(change_vertices_, wide ? sizeof(std::uint32_t) : sizeof(std::uint16_t));
    accessor["sparse"] = {
        {"count", changes.size()},
        {"indices",
         {{"bufferView", -1},
          {"byteOffset", vertices},
          {"componentType", wide ? kUnsignedInt : kUnsignedShort}}},
        {"values", {{"bufferView", -1}, {"byteOffset", aligned(change_values_, sizeof(T))}}}};
  }
  for (const Change& change : changes) {
    wide ? append(change_vertices_, change.vertex)
         : append(change_vertices_, static_cast<std::uint16_t>(change.vertex));
    for (glm::length_t i = 0; i < width; ++i) append(change_values_, stored<T>(change.by[i]));
  }
  accessors_.push_back(std::move(accessor));
  return index;
}

int GlbFile::position_changes(std::span<const Change> changes, std::size_t vertex_count) {
  const int index = this->changes<std::int16_t>(changes, vertex_count, kShort, 3);
  // Of the numbers as they are stored, and of the zeros between them.
  Json low = Json::array();
  Json high = Json::array();
  for (glm::length_t i = 0; i < 3; ++i) {
    const bool zeros = changes.size() < vertex_count;
    std::int16_t least = zeros ? 0 : std::numeric_limits<std::int16_t>::max();
    std::int16_t most = zeros ? 0 : std::numeric_limits<std::int16_t>::min();
    for (const Change& change : changes) {
      least = std::min(least, stored<std::int16_t>(change.by[i]));
      most = std::max(most, stored<std::int16_t>(change.by[i]));
    }
    low.push_back(least);
    high.push_back(most);
  }
  Json& accessor = accessors_[static_cast<std::size_t>(index)];
  accessor["min"] = std::move(low);
  accessor["max"] = std::move(high);
  return index;
}

int GlbFile::normal_changes(std::span<const Change> changes, std::size_t vertex_count) {
  return this->changes<std::int8_t>(changes, vertex_count, kByte, 3);
}

int GlbFile::colour_changes(std::span<const Change> changes, std::size_t vertex_count) {
  return this->changes<float>(changes, vertex_count, kFloat, 4);
}

int GlbFile::sample_times(std::span<const float> seconds) {
  AUCAST_CHECK(!seconds.empty());
  const int index = floats(seconds, "SCALAR");
  accessors_.back()["min"] = {seconds.front()};
  accessors_.back()["max"] = {seconds.back()};
  return index;
}

int GlbFile::morph_weights(std::span<const std::uint8_t> weights) {
  const int index =
      accessor(view(bytes_of(weights), kNoTarget), kUnsignedByte, "SCALAR", weights.size());
  accessors_.back()["normalized"] = true;
  return index;
}

int GlbFile::rotations(std::span<const glm::quat> rotations) {
  std::vector<std::array<float, 4>> xyzw;
  for (const glm::quat& q : rotations) xyzw.push_back({q.x, q.y, q.z, q.w});
  return floats(std::span<const std::array<float, 4>>(xyzw), "VEC4");
}

int GlbFile::translations(std::span<const glm::vec3> translations) {
  return floats(translations, "VEC3");
}

int GlbFile::png(std::string_view bytes) {
  images_.push_back({{"bufferView", view(bytes, kNoTarget)}, {"mimeType", "image/png"}});
  return static_cast<int>(images_.size()) - 1;
}

void GlbFile::append_changes() {
  if (change_vertices_.empty()) return;
  const int indices = view(change_vertices_, kNoTarget);
  const int values = view(change_values_, kNoTarget);
  for (Json& accessor : accessors_) {
    if (!accessor.contains("sparse")) continue;
    accessor["sparse"]["indices"]["bufferView"] = indices;
    accessor["sparse"]["values"]["bufferView"] = values;
  }
}

std::string GlbFile::bytes() {
  append_changes();
  pad(binary_, '\0');
  document_["accessors"] = std::move(accessors_);
  document_["bufferViews"] = std::move(views_);
  if (!images_.empty()) document_["images"] = std::move(images_);
  document_["buffers"] = {{{"byteLength", binary_.size()}}};
  // A file's name may be no UTF-8.
  std::string text = document_.dump(-1, ' ', false, Json::error_handler_t::replace);
  pad(text, ' ');
  std::string file;
  const auto add = [&file](std::size_t number) {
    append(file, static_cast<std::uint32_t>(number));
  };
  add(kMagic);
  add(kVersion);
  add(7 * sizeof(std::uint32_t) + text.size() + binary_.size());
  add(text.size());
  add(kJsonChunk);
  file += text;
  add(binary_.size());
  add(kBinaryChunk);
  file += binary_;
  return file;
}

}  // namespace aucast::glb
