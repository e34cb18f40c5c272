// A straight line of a width in pixels, which OpenGL's core profile does not have: four corners of
// a band for each segment. A segment without length becomes a round dot.

layout(location = 0) in vec3 a_from;
layout(location = 1) in vec3 a_to;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in float a_width_px;
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
