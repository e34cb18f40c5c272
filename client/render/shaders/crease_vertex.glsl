// Lines on the skin: they multiply what is there, so that they suit every skin and light. A ribbon
// is drawn a little nearer than it lies: the skin beneath is coarser and moves in flat pieces.

layout(location = 0) in vec3 a_position;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec2 a_occlusion_gloss;
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
