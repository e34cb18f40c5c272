in vec2 v_place;
uniform vec3 u_centre;
uniform vec3 u_edge;
uniform float u_square;  // of a chequer, in pixels; 0: a light that falls off
out vec4 o_colour;
void main() {
  vec2 from_light = vec2(v_place.x * 0.894, v_place.y - 0.1);
  float light = clamp(1.0 - 0.55 * length(from_light), 0.0, 1.0);
  if (u_square > 0.0) {
    vec2 square = floor(gl_FragCoord.xy / u_square);
    light = mod(square.x + square.y, 2.0);
  }
  o_colour = vec4(to_screen(mix(u_edge, u_centre, light)), 1.0);
}
