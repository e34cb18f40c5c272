in vec2 v_place;
uniform vec3 u_centre;
uniform vec3 u_edge;
out vec4 o_colour;
void main() {
  vec2 from_light = vec2(v_place.x * 0.894, v_place.y - 0.1);
  float light = clamp(1.0 - 0.55 * length(from_light), 0.0, 1.0);
  o_colour = vec4(to_screen(mix(u_edge, u_centre, light)), 1.0);
}
