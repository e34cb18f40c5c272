#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace aucast::view {

/// What a surface is drawn as; all but Surface have a light model of their own.
enum class Shader : std::uint8_t { Surface, Hair, Eye, Crease };

/// How a surface answers the light.
struct Material {
  Shader shader = Shader::Surface;
  /// Outermost first, so that what lies beneath is never shaded: 0 hair, 1 cloth, 2 skin, 3 the
  /// rest. What encloses the head (0 to 2) casts shadows and is what a transparent face lets
  /// through.
  std::uint8_t order = 3;
  bool two_sided = true;
  float wrap = 1;  ///< how far the key light reaches round into the shade; 1 is skin
  float specular = 0;
  float power = 20;       ///< of the highlight
  float shadow_kept = 0;  ///< share of the key light in its shadow, at least
  float grain = 0;        ///< pores and blotches; 1 is skin
  float thinning = 0;     ///< 1: fades where it is seen at a grazing angle
  float grey = 0;         ///< of hair: 1 is white hairs among dark ones
  float enclosed = 0;     ///< share of the ambient light that what shades it takes, too

  [[nodiscard]] bool encloses() const { return order < 3; }
};

struct MaterialRange {
  Material material;
  std::uint32_t triangle_begin = 0;
  std::uint32_t triangle_count = 0;
  int eye = -1;              ///< of an eyeball: index into eye_centres
  bool translucent = false;  ///< some vertex has alpha below 1: drawn after the solid ones
  int crease = -1;           ///< of a crease: index into creases
  bool rounded = false;      ///< drawn with a smoother outline than its triangles have
};

/// What does not change while a face is shown. Spans borrow from the caller.
struct StaticMesh {
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
  std::span<const glm::vec4> colours;                       ///< linear RGB, alpha
  std::span<const float> occlusion;                         ///< ambient light that arrives, [0,1]
  std::span<const float> gloss;                             ///< factor on the highlight
  std::span<const MaterialRange> ranges;
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

/// Where a face is looked at from: `target` from `distance`, turned by yaw (to the subject's left
/// is positive) and pitch (up is positive). A long lens, as for portraits.
struct Viewpoint {
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
  bool transparent = false;  ///< pictures have none; where there must be one it has these colours
  float squares_px = 0;      ///< a chequer of both colours, its squares so large; 0: no chequer
};

}  // namespace aucast::view
