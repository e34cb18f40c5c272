#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace aucast::view {

/// How a run of triangles takes light.
enum class Shading : std::uint8_t { Skin, Eye, Teeth, Mouth, Hair, Cloth, Brow, Crease };

struct ShadedRange {
  Shading shading = Shading::Skin;
  std::uint32_t triangle_begin = 0;
  std::uint32_t triangle_count = 0;
  int eye = -1;              ///< for Eye: index into eye_centres
  bool translucent = false;  ///< some vertex has alpha below 1: drawn after the solid ones
  int crease = -1;           ///< for Crease: index into creases
  bool rounded = false;      ///< drawn with a smoother outline than its triangles have
};

/// What does not change while a face is shown. Spans borrow from the caller.
struct StaticMesh {
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
  std::span<const glm::vec4> colours;                       ///< linear RGB, alpha
  std::span<const float> occlusion;                         ///< ambient light that arrives, [0,1]
  std::span<const float> gloss;                             ///< factor on the highlight
  std::span<const ShadedRange> ranges;
  std::span<const glm::vec3> rest = {};  ///< positions; without, no grain and no rounding
  /// Where across the hair a vertex lies, [0,1]: strands run where it is the same. Empty: no
  /// strands.
  std::span<const float> strand = {};
};

/// What changes with every frame.
struct MovingMesh {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::vec3> eye_centres;
  std::span<const glm::vec3> eye_forward;
  /// How deep the lines of each crease are, [0,1]; 0 is not drawn.
  std::span<const float> creases = {};
  /// 1: as at rest, 0: shut. A shut eye's cornea does not stand out, it would pierce the lid.
  /// Empty: all are open.
  std::span<const float> eye_open = {};
};

/// A camera that looks at `target` from `distance`, turned by yaw (to the subject's left is
/// positive) and pitch (up is positive). The long lens flatters (face.md 5).
struct Camera {
  glm::vec3 target{0.0F, 0.6F, 2.0F};
  float distance = 60;
  float yaw_rad = 0;
  float pitch_rad = 0;
  /// Half the height of what is seen at the target, mesh units.
  float half_height = 11.0F;
};

struct Background {
  glm::vec3 centre{0.28F, 0.30F, 0.33F};  ///< linear
  glm::vec3 edge{0.055F, 0.062F, 0.075F};
};

}  // namespace aucast::view
