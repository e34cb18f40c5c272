#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

namespace aucast::glb {

/// Objects keep the order in which they were filled, so the same face gives the same bytes.
using Json = nlohmann::ordered_json;

[[nodiscard]] Json vector_of(const glm::vec3& v);

/// How much one vertex of a mesh is changed.
struct Change {
  std::uint32_t vertex = 0;
  glm::vec4 by{0};  ///< xyz of a position or a normal; rgba of a colour
};

/// What the extension is called in which small numbers stand for what morph targets change.
inline constexpr const char* kQuantization = "KHR_mesh_quantization";

/// A change of a position as the file has it: in steps of a 32767th of a metre, 0.03 mm.
[[nodiscard]] glm::vec3 stored_position_change(const glm::vec3& metres);

/// A binary glTF 2.0 file that is being made: the JSON document, and the numbers that it refers to.
/// Each function that stores numbers returns the index of their accessor.
class GlbFile {
 public:
  GlbFile();

  /// The document, to be filled by the caller, except for accessors, bufferViews, buffers and
  /// images, which the functions below make.
  Json& document() { return document_; }

  [[nodiscard]] int positions(std::span<const glm::vec3> positions);
  [[nodiscard]] int normals(std::span<const glm::vec3> normals);
  /// Colours are clamped to [0,1] and stored as 16 bits.
  [[nodiscard]] int colours(std::span<const glm::vec4> colours);
  [[nodiscard]] int texture_coordinates(std::span<const glm::vec2> coordinates);
  [[nodiscard]] int joints(std::span<const std::array<std::uint8_t, 4>> joints);
  /// The weights of each vertex must sum to 1. They are rounded to 16 bits such that they still do.
  [[nodiscard]] int joint_weights(std::span<const std::array<float, 4>> weights);
  [[nodiscard]] int triangles(std::span<const std::array<std::uint32_t, 3>> triangles,
                              std::size_t vertex_count);
  [[nodiscard]] int inverse_bind_matrices(std::span<const std::array<float, 16>> matrices);

  /// What a morph target changes: the vertices in `changes` (ascending) out of `vertex_count`; all
  /// others stay. Positions change by one metre at most, in 16 bits, and normals in 8, for which
  /// the document has to name kQuantization.
  [[nodiscard]] int position_changes(std::span<const Change> changes, std::size_t vertex_count);
  [[nodiscard]] int normal_changes(std::span<const Change> changes, std::size_t vertex_count);
  [[nodiscard]] int colour_changes(std::span<const Change> changes, std::size_t vertex_count);

  // For animations.
  [[nodiscard]] int sample_times(std::span<const float> seconds);          ///< ascending
  [[nodiscard]] int morph_weights(std::span<const std::uint8_t> weights);  ///< 255 is 1
  [[nodiscard]] int rotations(std::span<const glm::quat> rotations);
  [[nodiscard]] int translations(std::span<const glm::vec3> translations);

  /// Returns the index of the image.
  [[nodiscard]] int png(std::string_view bytes);

  /// The whole file. Call it once, at the end.
  [[nodiscard]] std::string bytes();

 private:
  int view(std::string_view bytes, int target);
  int accessor(int view, int component, std::string_view type, std::size_t count);
  template <typename T>
  int vertices(std::span<const T> values, int component, std::string_view type);
  int shares(std::span<const std::array<std::uint16_t, 4>> shorts);
  template <typename T>
  int floats(std::span<const T> values, std::string_view type);
  template <typename T>
  int changes(std::span<const Change> changes, std::size_t vertex_count, int component, int width);
  void append_changes();

  Json document_;
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  Json images_ = Json::array();
  std::string binary_;
  // The changes of all morph targets, which get two views of their own.
  std::string change_vertices_;
  std::string change_values_;
  std::map<std::pair<int, std::size_t>, int> zeros_;  ///< accessors, by component type and vertices
};

}  // namespace aucast::glb
