// Put before every stage. Light is linear; fragment shaders end with to_screen(), so that the
// framebuffer is plain 8 bits without sRGB conversion. The blocks mirror the structs of
// uniform_blocks.h member by member.

layout(std140) uniform Camera {
  mat4 u_world_to_clip;
  mat4 u_world_to_shadow;  // into [0,1] of the shadow map
  vec3 u_eye;              // where the camera stands
  float u_scale;           // of lines and dots
  vec2 u_viewport_px;
};

// A soft key from the upper right of the subject, a fill from the other side, two rims from behind,
// sky and ground. Directions are unit vectors towards the light.
layout(std140) uniform Lights {
  vec3 u_key_direction;
  float u_key_strength;  // 1 is the studio's
  vec3 u_key_colour;
  float u_fill_wrap;     // how far the fill reaches round into the shade
  vec3 u_fill_direction;
  float u_rim_strength;
  vec3 u_fill_colour;
  float u_second_rim_strength;
  vec3 u_rim_direction;
  vec3 u_rim_colour;
  vec3 u_second_rim_direction;
  vec3 u_second_rim_colour;
  vec3 u_sky;
  vec3 u_ground;
};

layout(std140) uniform Material {
  vec3 u_wrap;         // how far the key reaches round into the shade, per colour
  float u_specular;
  vec3 u_shadow_kept;  // share of the key that is left in its shadow
  float u_power;       // of the broad highlight; the narrow one has four times that
  float u_grain;       // contrast of the grain; 1 is skin
  float u_thinning;    // 1: translucent parts fade where they are seen at a grazing angle
  float u_grey;        // hair: 0 one colour, 1 white hairs among dark ones
};

// A shoulder that keeps highlights from burning out, then gamma 2.0 (a square root).
vec3 to_screen(vec3 light) {
  light = max(light, vec3(0.0));
  return sqrt(min(light / (1.0 + 0.14 * light), vec3(1.0)));
}
