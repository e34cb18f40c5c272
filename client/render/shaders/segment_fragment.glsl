in vec4 v_colour;
in vec3 v_place;
uniform float u_alpha;
out vec4 o_colour;
void main() {
  float inside = clamp(v_place.z + 0.5 - length(v_place.xy), 0.0, 1.0);
  o_colour = vec4(v_colour.rgb, v_colour.a * u_alpha * inside);
}
