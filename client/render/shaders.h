#pragma once

namespace aucast::render::shaders {

// GLSL 3.30. Light and colours after face.md section 5: a soft key from the upper right of the
// subject, a fill from the other side, two rims from behind, sky and ground through the baked
// occlusion. All light is in linear space; the fragment shaders end with tone and gamma, so that
// the framebuffer is plain 8 bits without sRGB conversion.

inline constexpr const char* kVersion = "#version 330 core\n";
/// Set before kLitFragment; one program each, so that no pixel pays for another material.
inline constexpr const char* kAsSurface = "#define SURFACE\n";
inline constexpr const char* kAsHair = "#define HAIR\n";
inline constexpr const char* kAsEye = "#define EYE\n";

/// What depends smoothly on the surface is worked out per vertex: sky, ground, fill and its
/// highlight.
inline constexpr const char* kLitVertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec2 a_occlusion_gloss;
#ifndef EYE
layout(location = 4) in vec2 a_grain;  // goes with the surface
out vec2 v_grain;
#endif

uniform mat4 u_world_to_clip;
uniform mat4 u_world_to_shadow;  // into [0,1] of the shadow map
uniform sampler2DShadow u_shadow_map;
uniform vec3 u_eye;             // the camera
uniform vec3 u_fill_direction;  // unit vector towards the light
uniform float u_specular;
uniform float u_power;          // of the broad highlight; the narrow one has four times that

#ifdef EYE
uniform vec3 u_eyeball_centre;
uniform vec3 u_eyeball_forward;
uniform float u_eyeball_open;
out vec3 v_position;
#endif
#ifdef HAIR
layout(location = 5) in vec4 a_strand;  // its way, its number
out vec4 v_strand;
#endif
out vec3 v_view;
out vec3 v_normal;
out vec4 v_colour;
out vec3 v_ambient;
out vec3 v_shine;  // occlusion, strength of the key's highlight, the fill's highlight
out float v_key;  // how much of the key arrives past what casts a shadow

const vec3 kGround = vec3(0.35, 0.265, 0.225);
const vec3 kSky = vec3(0.38, 0.385, 0.41);
const vec3 kFill = vec3(0.34, 0.32, 0.33);
const float kFillWrap = 0.35;
const float kShadowLift = 0.06;  // along the normal, against a surface shading itself
const float kShadowStep = 0.009;  // of the map's side

// The edge of a shadow is as soft as a large lamp's, wider than the vertices are apart: one
// wide look per vertex costs half of a narrow one per pixel, and no texel shows.
float key_arriving(vec3 place) {
  float sum = 0.0;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      vec2 aside = (vec2(float(column), float(row)) - 1.5) * kShadowStep;
      sum += textureLod(u_shadow_map, place + vec3(aside, 0.0), 0.0);
    }
  }
  return sum / 16.0;
}

#ifdef EYE
const float kCorneaEnd = 1.3;     // radians from where the eye looks
const float kCorneaWidens = 0.94;  // so that no two points change places it is less than 1
const float kCorneaBulge = 0.062;  // share of the ball's radius
const float kCorneaRim = 0.56;     // radians; the iris ends a little before

// The cornea stands out and bends light: from the side an iris looks far wider than one painted on
// a ball. The ball's points slide over it, away from where the eye looks, those towards the viewer
// most, so that the edge of the iris stays an ellipse. Only from the side does the cornea itself
// show, and of an open eye: else it would pierce the lids.
vec3 seen_through_cornea(vec3 place) {
  vec3 arm = place - u_eyeball_centre;
  vec3 aside = arm - dot(arm, u_eyeball_forward) * u_eyeball_forward;
  if (dot(aside, aside) < 1e-8) return place;
  float angle = acos(clamp(dot(normalize(arm), u_eyeball_forward), -1.0, 1.0));
  vec3 viewer = normalize(u_eye - u_eyeball_centre);
  aside = normalize(aside);
  float sideways = smoothstep(0.2, 0.9, 1.0 - dot(viewer, u_eyeball_forward));
  float inside = max(1.0 - angle / kCorneaEnd, 0.0);
  float nearer = max(dot(aside, viewer), 0.0);
  float bulge = max(1.0 - angle * angle / (kCorneaRim * kCorneaRim), 0.0);
  bulge *= bulge * smoothstep(0.5, 0.95, u_eyeball_open);
  bulge *= 1.0 - 0.45 * smoothstep(0.0, 0.8, -aside.y);  // its tip would stand before the lower lid
  angle += kCorneaWidens * sideways * nearer * nearer * nearer * angle * inside;
  vec3 direction = cos(angle) * u_eyeball_forward + sin(angle) * aside;
  return u_eyeball_centre +
         length(arm) * (direction + kCorneaBulge * sideways * bulge * u_eyeball_forward);
}
#endif

void main() {
  float occlusion = a_occlusion_gloss.x;
#ifdef EYE
  vec3 place = seen_through_cornea(a_position);
#else
  vec3 place = a_position;
#endif
  // Light that bounces about in skin comes out red: less of the red is lost in the creases.
  vec3 arriving = vec3(pow(max(occlusion, 1e-4), 0.75), occlusion, occlusion);
  float fill = max(dot(a_normal, u_fill_direction) * (1.0 - kFillWrap) + kFillWrap, 0.0);
  v_ambient = arriving * (mix(kGround, kSky, 0.5 + 0.5 * a_normal.y) + kFill * fill);
#ifdef EYE
  v_position = place;
#endif
#ifndef EYE
  v_grain = a_grain;
#endif
#ifdef HAIR
  v_strand = a_strand;
#endif
  v_view = normalize(u_eye - place);
  v_normal = a_normal;
  v_colour = a_colour;
#ifdef SURFACE
  // Brows (translucent, and lashes have no gloss) thin out where the skin turns away: seen along it
  // their inner ends are a hook.
  if (a_colour.a < 1.0 && a_occlusion_gloss.y > 0.0) {
    v_colour.a *= smoothstep(0.05, 0.58, abs(dot(a_normal, v_view)));
  }
#endif
  v_key = key_arriving((u_world_to_shadow * vec4(place + a_normal * kShadowLift, 1.0)).xyz);
  float specular = u_specular * a_occlusion_gloss.y;
  float across = dot(a_normal, normalize(u_fill_direction + v_view));
  v_shine = vec3(occlusion, specular * (0.4 + 0.6 * occlusion),
                 0.25 * specular * exp(u_power * (across - 1.0)) * occlusion);
  gl_Position = u_world_to_clip * vec4(place, 1.0);
}
)";

/// Shared by all that ends on the screen.
inline constexpr const char* kTone = R"(
// A shoulder that keeps highlights from burning out, then gamma 2.0 (a square root, face.md 5).
vec3 to_screen(vec3 light) {
  light = max(light, vec3(0.0));
  return sqrt(min(light / (1.0 + 0.14 * light), vec3(1.0)));
}
)";

inline constexpr const char* kLitFragment = R"(
#ifdef EYE
in vec3 v_position;
#endif
#ifndef EYE
in vec2 v_grain;
#endif
#ifdef SURFACE
uniform float u_grain;  // 1 is skin's
uniform sampler2D u_grain_map;
#endif
#ifdef HAIR
in vec4 v_strand;
#endif
in vec3 v_view;
in vec3 v_normal;
in vec4 v_colour;
in vec3 v_ambient;
in vec3 v_shine;
in float v_key;

uniform vec3 u_key_direction;  // unit vectors towards the lights
uniform float u_key_strength;  // 1 is the studio's
uniform vec3 u_rim_direction;
uniform vec3 u_second_rim_direction;
uniform float u_wrap;          // how far light creeps round into the shade; 1 is skin
uniform float u_power;
uniform float u_shadow_kept;   // of the key in its shadow, at least
uniform vec3 u_eyeball_centre;
uniform vec3 u_eyeball_forward;

out vec4 o_colour;

const vec3 kKey = vec3(1.05, 0.97, 0.88);
const vec3 kKeyWrap = vec3(0.30, 0.19, 0.15);
const vec3 kShadowKept = vec3(0.30, 0.14, 0.11);  // shadows on skin go red, not grey

#ifdef HAIR
uniform vec3 u_fill_direction;
const float kStrands = 900.0;  // side by side round the head
const float kShineShift = 0.10;
const float kPieces = 8.0;  // of a strand, on the way that v_grain counts

// How much shows of strands that are `width` pixels wide or of what is coarser by that factor.
float fineness(float at) { return 1.0 - smoothstep(0.5, 1.4, fwidth(at)); }

uvec2 scatter(uvec2 n) {
  n = n * 747796405u + 2891336453u;
  n = ((n >> ((n >> 28u) + 4u)) ^ n) * 277803737u;
  return (n >> 22u) ^ n;
}

vec2 signed_share(uvec2 n) { return vec2(n) / 2147483648.0 - 1.0; }

// A fixed pseudo-random number in [-1, 1] for each whole number, smooth between them.
float strand_noise(float at) {
  vec2 value = signed_share(scatter(uvec2(floor(at) + vec2(0.0, 1.0))));
  return mix(value.x, value.y, smoothstep(0.0, 1.0, fract(at)));
}

// The same, and changing along each strand, where each likes: a hair is seldom on top all its way.
float piece_noise(float at, float along) {
  uvec2 strand = scatter(uvec2(floor(at) + vec2(0.0, 1.0)));
  vec2 place = along + 64.0 + vec2(strand & 1023u) / 128.0;
  uvec2 piece = strand ^ (uvec2(place) * 1664525u);
  uvec2 next = strand ^ ((uvec2(place) + 1u) * 1664525u);
  vec2 value = mix(signed_share(scatter(piece)), signed_share(scatter(next)),
                   smoothstep(0.0, 1.0, fract(place)));
  value = 0.45 * signed_share(strand) + 0.75 * value;
  return mix(value.x, value.y, smoothstep(0.0, 1.0, fract(at)));
}

// The way a strand takes on a surface; downhill on one without strands.
vec3 way_of_strands(vec3 normal) {
  vec3 along = v_strand.xyz - normal * dot(v_strand.xyz, normal);
  float length2 = dot(along, along);
  if (length2 < 1e-12) {
    along = vec3(0.0, -1.0, 0.0) + normal * normal.y;
    length2 = max(dot(along, along), 1e-4);
  }
  return along * inversesqrt(length2);
}

// Strands shine like wires: across themselves in every direction, so that the highlight becomes a
// band. A white one nearer to the roots and one in the colour of the hair nearer to the tips
// (Marschner 2003), each strand at its own place.
vec3 strand_shine(vec3 normal, vec3 along, vec3 view, vec3 colour, float strand, float key) {
  vec3 halfway = normalize(u_key_direction + view);
  vec3 fill_halfway = normalize(u_fill_direction + view);
  // Locks differ as strands do, or the band would be drawn with a ruler.
  float astray = 0.18 * strand + 0.06 * strand_noise(v_strand.w * 90.0 + 7000.0);
  float tilt = dot(along, halfway) + astray;
  float up = tilt - kShineShift;
  float down = tilt + kShineShift;
  float fill_tilt = dot(along, fill_halfway) + astray;
  float lit = clamp(dot(normal, u_key_direction) + 0.3, 0.0, 1.0) * key;
  float fill_lit = clamp(dot(normal, u_fill_direction) + 0.3, 0.0, 1.0);
  float broad = exp(-u_power * down * down);
  float narrow = exp(-4.0 * u_power * up * up);
  float filled = 0.3 * exp(-2.0 * u_power * fill_tilt * fill_tilt) * fill_lit;
  // Half the hue of the hair: plain white makes brown hair look dusty.
  vec3 white = 0.5 + 0.5 * colour / max(max(colour.r, colour.g), max(colour.b, 0.01));
  vec3 shine = 2.4 * colour * (broad * lit + filled) +
               0.33 * white * (narrow * max(1.0 + 1.7 * strand, 0.0) * lit);
  // Not at the very outline, where single pixels would sparkle.
  return shine * smoothstep(0.0, 0.3, dot(normal, view));
}

// How light the strand here is, in [-1, 1], and so its colour: single ones and, about four times as
// wide, tufts. Every strand of an edge ends where it likes: `cover` is what is left of it.
float strand_here(inout vec3 colour, out float cover) {
  float at = v_strand.w * kStrands;
  // Grey hair is white hairs among dark ones; one colour shows in longer pieces.
  float grey = 1.0 - smoothstep(0.02, 0.06, colour.r - colour.b);
  float pieces = mix(0.3, 0.6, grey) * kPieces;
  float along = at > 0.0 ? (v_grain.y - v_grain.x) * pieces : 0.0;  // none on bare clay
  float visible = fineness(at);
  float fine = piece_noise(at, along) * visible;
  float tuft = strand_noise(at * 0.27 + 5000.0) * fineness(at * 0.27);
  // A tuft does not stay light or dark from root to tip.
  tuft *= sin(9.0 * v_grain.y + 6.0 * strand_noise(at * 0.06 + 9000.0));
  cover = 1.0;
  if (v_colour.a < 1.0) {
    // Not the noise of the colour, or the longest strands would be the dark ones.
    float length_here = piece_noise(at * 1.6 + 3000.0, along * 2.5) * visible;
    float cut = 0.5 + 0.45 * length_here + 0.12 * tuft;
    float soft = mix(0.5, 0.42, visible);
    cover = smoothstep(cut - soft, cut + soft, mix(-0.7, 1.7, v_colour.a));
  }
  float strand = 0.55 * (fine + (1.0 - 0.5 * grey) * tuft);
  colour *= 1.0 + mix(0.42, 0.78, grey) * strand;
  return strand;
}
#endif

// What the key gives a surface; `arriving` is how much of it no shadow takes.
vec3 key_light(vec3 normal, float occlusion, out float arriving) {
  vec3 wrap = kKeyWrap * u_wrap;
  float towards_key = dot(normal, u_key_direction);
  vec3 lit = clamp((towards_key + wrap) / (1.0 + wrap), 0.0, 1.0);
  // Where the surface turns away from the key it is its own shadow; the map would only draw its
  // texels there.
  arriving = mix(1.0, v_key, smoothstep(-0.20, 0.15, towards_key));
  vec3 through = mix(max(kShadowKept * u_wrap, vec3(u_shadow_kept)), vec3(1.0), arriving);
  return lit * through * kKey * (u_key_strength * (0.55 + 0.45 * occlusion));
}

#ifdef EYE
const float kCatchlight = 0.068;  // half its side, of the ball's radius

vec3 with_reflections(vec3 lit, vec3 view, vec3 normal) {
  // Reflections of a window where a portrait painter puts them: true ones hide behind the lids as
  // soon as the head turns, and the face dies.
  vec3 side = normalize(vec3(view.z, 0.0, -view.x));
  vec3 up = cross(view, side);
  // They stay on the iris also in profile, or the eye is a painted ball.
  float sideways = smoothstep(0.1, 0.8, 1.0 - dot(view, u_eyeball_forward));
  vec3 middle = mix(view, u_eyeball_forward, 0.82);
  vec3 first = normalize(middle - side * 0.13 * (1.0 - sideways) + up * mix(0.135, 0.09, sideways));
  vec3 second = normalize(middle + side * 0.17 - up * 0.20);
  // A window is square, lighter at its upper edge, and soft on a wet ball.
  vec3 aside = normal - first;
  vec2 pane = vec2(dot(aside, side), dot(aside, up)) / kCatchlight;
  vec2 pane2 = pane * pane;
  float window = smoothstep(2.0, 0.0, dot(pane2, pane2)) * (0.85 + 0.15 * pane.y);
  lit = mix(lit, vec3(0.90, 0.90, 0.88), 0.94 * window);
  lit += vec3(0.07) * smoothstep(0.986, 0.999, dot(normal, second));
  // From the side the front of the cornea is clear: what lies behind it shows, not the pupil.
  float facing = 1.0 - max(dot(normal, view), 0.0);
  return mix(lit, vec3(0.40, 0.37, 0.35), 0.60 * sideways * smoothstep(0.62, 1.0, facing));
}
#endif

void main() {
  vec3 view = v_view;  // near enough to unit length between near vertices
  vec3 colour = v_colour.rgb;
  float occlusion = v_shine.x;
#ifdef EYE
  vec3 from_centre = v_position - u_eyeball_centre;
  vec3 normal = normalize(from_centre);
#else
  vec3 normal = normalize(v_normal);
#ifdef HAIR
  float cover;
  float strand = strand_here(colour, cover);
  vec3 along = way_of_strands(normal);
#else
  normal = gl_FrontFacing ? normal : -normal;
  vec2 grain = u_grain * (texture(u_grain_map, v_grain).rg - 128.0 / 255.0);
  colour *= 1.0 + grain.r * vec3(0.11, 0.17, 0.19);  // more blood or less: red changes least
#endif
#endif

  float arriving;
  vec3 result = colour * (key_light(normal, occlusion, arriving) + v_ambient);

#ifdef EYE
  // The upper lid and its lashes shade the ball below them.
  result *= mix(1.0, 0.36, smoothstep(-0.05, 0.50, from_centre.y));
  // The lower lid meets it in shade, or the ball is a wedge with a cut end.
  result *= mix(0.62, 1.0, smoothstep(-0.50, -0.12, from_centre.y));
  result = with_reflections(result, view, normal);
#else
#ifdef HAIR
  vec3 specular =
      strand_shine(normal, along, view, colour, strand, arriving * u_key_strength) * v_shine.y;
#else
  // exp(n (c - 1)) is cos to the n near its top, for half the work.
  vec3 halfway = u_key_direction + view;
  float aligned = dot(normal, halfway) * inversesqrt(dot(halfway, halfway));
  float broad = exp(u_power * (aligned - 1.0));
  float narrow = broad * broad * broad * broad;
  float shone = arriving * u_key_strength;
  float specular = (0.65 * broad + 0.35 * narrow) * shone * v_shine.y + v_shine.z;
#endif

  float facing = 1.0 - max(dot(normal, view), 0.0);
  // Never to the full: the last pixel of an ear would be a white thread.
  float edge = facing * facing;
  edge = min(edge * edge * sqrt(facing), 0.45);
  vec3 rim = vec3(0.75, 0.80, 0.95) *
                 (0.75 * max(dot(normal, u_rim_direction) + 0.15, 0.0)) +
             vec3(0.90, 0.75, 0.60) *
                 (0.28 * max(dot(normal, u_second_rim_direction) + 0.15, 0.0));
#ifdef HAIR
  result += specular + rim * (edge * occlusion * 0.18);
#else
  result += vec3(1.0, 0.98, 0.95) * (specular * (1.0 + 1.3 * grain.g)) +
            rim * (0.10 + 0.95 * colour) * (edge * occlusion * occlusion * occlusion);
#endif
#endif
#ifdef HAIR
  o_colour = vec4(to_screen(result), cover);
#else
  o_colour = vec4(to_screen(result), v_colour.a);
#endif
}
)";

/// Lines on the skin: they multiply what is there, so that they suit every skin and light. A ribbon
/// is drawn a little nearer than it lies: the skin beneath is coarser and moves in flat pieces.
inline constexpr const char* kCreaseVertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec2 a_occlusion_gloss;
uniform mat4 u_world_to_clip;
uniform vec3 u_eye;
uniform float u_strength;
out vec3 v_factor;
const float kNearer = 0.10;
const float kBulge = 0.10;  // more light beside the deepest line
void main() {
  vec3 lost = a_colour.a * (vec3(1.0) - a_colour.rgb);
  v_factor = vec3(1.0) + u_strength * (kBulge * a_occlusion_gloss.y - lost);
  vec3 nearer = a_position + kNearer * normalize(u_eye - a_position);
  gl_Position = u_world_to_clip * vec4(nearer, 1.0);
}
)";

/// For blending source x destination twice: half is no change. The square root as in kTone.
inline constexpr const char* kCreaseFragment = R"(
in vec3 v_factor;
out vec4 o_colour;
void main() { o_colour = vec4(0.5 * sqrt(v_factor), 0.5); }
)";

inline constexpr const char* kDepthVertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_world_to_clip;
void main() { gl_Position = u_world_to_clip * vec4(a_position, 1.0); }
)";

inline constexpr const char* kDepthFragment = "void main() {}\n";

/// The mesh's lines and points, in one colour.
inline constexpr const char* kFlatVertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_world_to_clip;
uniform float u_point_px;
void main() {
  gl_Position = u_world_to_clip * vec4(a_position, 1.0);
  gl_PointSize = u_point_px;
}
)";

inline constexpr const char* kFlatFragment = R"(
uniform vec4 u_colour;
out vec4 o_colour;
void main() { o_colour = u_colour; }
)";

/// A straight line of a width in pixels, which OpenGL's core profile does not have: four corners of
/// a band for each segment. A segment without length becomes a round dot.
inline constexpr const char* kSegmentVertex = R"(
layout(location = 0) in vec3 a_from;
layout(location = 1) in vec3 a_to;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in float a_width_px;
uniform mat4 u_world_to_clip;
uniform vec2 u_viewport_px;
uniform float u_scale;
out vec4 v_colour;
out vec3 v_place;  // pixels: along a dot's radius or 0, aside, half the width
const float kNearer = 0.0004;  // towards the viewer, so that a tag stands on its surface
void main() {
  vec4 from = u_world_to_clip * vec4(a_from, 1.0);
  vec4 to = u_world_to_clip * vec4(a_to, 1.0);
  vec2 way = (to.xy / to.w - from.xy / from.w) * u_viewport_px * 0.5;
  float length_px = length(way);
  bool dot_only = a_from == a_to;
  vec2 along = length_px > 1e-3 ? way / length_px : vec2(1.0, 0.0);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  float half_px = 0.5 * max(a_width_px * u_scale, 1.0);
  float reach = half_px + 1.0;
  vec2 moved = vec2(-along.y, along.x) * corner.y * reach;
  if (dot_only) moved += along * corner.x * reach;
  vec4 place = corner.x < 0.0 ? from : to;
  place.xy += moved / (u_viewport_px * 0.5) * place.w;
  place.z -= kNearer * place.w;
  gl_Position = place;
  v_colour = a_colour;
  v_place = vec3(dot_only ? corner.x * reach : 0.0, corner.y * reach, half_px);
}
)";

inline constexpr const char* kSegmentFragment = R"(
in vec4 v_colour;
in vec3 v_place;
uniform float u_alpha;
out vec4 o_colour;
void main() {
  float inside = clamp(v_place.z + 0.5 - length(v_place.xy), 0.0, 1.0);
  o_colour = vec4(v_colour.rgb, v_colour.a * u_alpha * inside);
}
)";

/// One triangle over the whole picture at the far plane.
inline constexpr const char* kBackdropVertex = R"(
out vec2 v_place;
void main() {
  v_place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(v_place, 1.0, 1.0);
}
)";

inline constexpr const char* kBackdropFragment = R"(
in vec2 v_place;
uniform vec3 u_centre;
uniform vec3 u_edge;
out vec4 o_colour;
void main() {
  vec2 from_light = vec2(v_place.x * 0.894, v_place.y - 0.1);
  float light = clamp(1.0 - 0.55 * length(from_light), 0.0, 1.0);
  o_colour = vec4(to_screen(mix(u_edge, u_centre, light)), 1.0);
}
)";

}  // namespace aucast::render::shaders
