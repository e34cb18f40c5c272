#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace aucast::view {

/// How a surface is lit. All but Surface have a special light model.
enum class Shader : std::uint8_t { Surface, Hair, Eye, Crease };

/// How a surface reacts to light.
struct Material {
  Shader shader = Shader::Surface;
  /// The order of drawing, outermost first, so that hidden pixels need not be shaded: 0 hair, 1
  /// cloth, 2 skin, 3 the rest. Materials 0 to 2 enclose the head: only they cast shadows, and only
  /// they are see-through in a transparent face.
  std::uint8_t order = 3;
  bool two_sided = true;
  float wrap = 1;  ///< how far the key light reaches round into the shade; 1 is skin
  float specular = 0;
  float power = 20;       ///< exponent of the highlight: the larger, the smaller the highlight
  float shadow_kept = 0;  ///< share of the key light that remains in its shadow
  float grain = 0;        ///< pores and blotches; 1 is skin
  float thinning = 0;     ///< 1: fades where it is seen at a grazing angle; 0: does not
  float grey = 0;         ///< hair: 1 has white hairs among dark ones
  float enclosed = 0;     ///< 0 to 1: how much of the ambient light is lost where the key light is
                          ///< blocked

  [[nodiscard]] bool encloses() const { return order < 3; }
};

struct MaterialRange {
  Material material;
  std::uint32_t triangle_begin = 0;
  std::uint32_t triangle_count = 0;
  int eye = -1;              ///< an eyeball's index into eye_centres; -1: no eyeball
  bool translucent = false;  ///< some vertex has alpha below 1, so it is drawn after the opaque
                             ///< ranges
  int crease = -1;           ///< a crease's index into creases; -1: no crease
  bool rounded = false;      ///< drawn with RoundedMesh, so that its outline shows no corners
};

/// What does not change while a face is shown. Spans borrow from the caller.
struct StaticMesh {
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
  std::span<const glm::vec4> colours;                       ///< linear RGB, alpha
  std::span<const float> occlusion;  ///< share of the ambient light that arrives, [0,1]
  std::span<const float> gloss;      ///< factor for the highlight
  std::span<const MaterialRange> ranges;
  std::span<const glm::vec3> rest = {};  ///< positions at rest; empty: no grain and no rounding
  /// Each vertex's position across the hair, [0,1]: along a strand it is constant. Empty: no
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
  /// How far each eye is open; 1: as at rest, 0: shut. The cornea of a shut eye is flat, or it
  /// would pierce the lid. Empty: all are open.
  std::span<const float> eye_open = {};
};

/// Where a face is looked at from: `distance` from `target` (mesh units), turned by yaw (positive:
/// to the subject's left) and pitch (positive: up). The defaults are a long lens, as for portraits.
struct Viewpoint {
  glm::vec3 target{0.0F, 0.6F, 2.0F};
  float distance = 60;
  float yaw_rad = 0;
  float pitch_rad = 0;
  /// Half the height of what is seen at the target, mesh units.
  float half_height = 11.0F;
};

struct Background {
  glm::vec3 centre{0.28F, 0.30F, 0.33F};  ///< linear RGB
  glm::vec3 edge{0.055F, 0.062F, 0.075F};
  bool transparent = false;  ///< picture files get no background; where there must be a background,
                             ///< it has these colours
  float squares_px = 0;  ///< the size of the squares of a chequer in both colours; 0: no chequer
};

}  // namespace aucast::view
