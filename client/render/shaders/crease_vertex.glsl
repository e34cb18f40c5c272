// Lines on the skin. A ribbon is drawn a little nearer than it lies: the skin beneath is coarser
// and moves in flat pieces.

layout(location = 0) in vec3 a_position;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec2 a_occlusion_gloss;
uniform float u_strength;
out vec3 v_position;
out vec3 v_lost;    // share of the light that does not reach the ground of the fold
out vec2 v_relief;  // where across the fold, 0 to 1 from the side of the bulge; how deep it is
const float kNearer = 0.10;
void main() {
  v_position = a_position;
  v_lost = u_strength * a_colour.a * (vec3(1.0) - a_colour.rgb);
  v_relief = vec2(a_occlusion_gloss.x, u_strength * a_occlusion_gloss.y);
  vec3 nearer = a_position + kNearer * normalize(u_eye - a_position);
  gl_Position = u_world_to_clip * vec4(nearer, 1.0);
}
