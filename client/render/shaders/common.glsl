// Put before every stage. Light is linear; fragment shaders end with to_screen() or to_film(), so
// that the framebuffer is plain 8 bits without sRGB conversion. The blocks mirror the structs of
// uniform_blocks.h member by member.

layout(std140) uniform Camera {
  mat4 u_world_to_clip;
  mat4 u_world_to_shadow;  // into [0,1] of the shadow map
  vec3 u_eye;              // where the camera stands
  float u_scale;           // of lines and dots
  vec2 u_viewport_px;
};

// A soft key from the upper right of the subject, a fill from the other side, two rims from behind,
// sky and ground. Directions are unit vectors towards the light. Only the key changes: what is
// constant costs a software renderer less than a uniform.
layout(std140) uniform Lights {
  vec3 u_key_direction;
  float u_key_strength;  // 1 is the studio's
};
const vec3 kKeyColour = vec3(1.64, 1.495, 1.35);
const float kFillWrap = 0.35;  // how far the fill reaches round into the shade
const vec3 kFillDirection = vec3(0.835504472, 0.0982946381, 0.540620506);
const vec3 kFillColour = vec3(0.158, 0.147, 0.152);
const float kRimStrength = 0.52;
const vec3 kRimDirection = vec3(0.596480846, 0.41294831, -0.688247204);
const vec3 kRimColour = vec3(0.75, 0.80, 0.95);
const float kSecondRimStrength = 0.28;
const vec3 kSecondRimDirection = vec3(-0.766261041, 0.287347883, -0.574695766);
const vec3 kSecondRimColour = vec3(0.90, 0.75, 0.60);
const vec3 kSky = vec3(0.182, 0.181, 0.196);
const vec3 kGround = vec3(0.121, 0.105, 0.101);

layout(std140) uniform Material {
  vec3 u_wrap;         // how far the key reaches round into the shade, per colour
  float u_specular;
  vec3 u_shadow_kept;  // share of the key that is left in its shadow
  float u_power;       // of the broad highlight; the narrow one has four times that
  float u_grain;       // contrast of the grain; 1 is skin
  float u_thinning;    // 1: translucent parts fade where they are seen at a grazing angle
  float u_grey;        // hair: 0 one colour, 1 white hairs among dark ones
  float u_enclosed;    // 1: what takes the key takes the ambient light, too, as lips do
};

// How much of the key a surface takes that nothing shades, per colour.
vec3 key_share(vec3 normal) {
  vec3 lit = max((dot(normal, u_key_direction) + u_wrap) / (1.0 + u_wrap), 0.0);
  return lit * lit;  // it ends softly, or a red ring lies round the shade
}

// What sky, ground and fill give a surface that nothing shades.
vec3 ambient_light(vec3 normal) {
  float fill = max(dot(normal, kFillDirection) * (1.0 - kFillWrap) + kFillWrap, 0.0);
  return mix(kGround, kSky, 0.5 + 0.5 * normal.y) + kFillColour * fill;
}

// A shoulder that keeps highlights from burning out, then gamma 2.0 (a square root).
vec3 to_screen(vec3 light) {
  light = max(light, vec3(0.0));
  return sqrt(min(light / (1.0 + 0.14 * light), vec3(1.0)));
}

// The same with a film's contrast: without it a lit face is a mask.
vec3 to_film(vec3 light) {
  vec3 tone = to_screen(light);
  return mix(tone, tone * tone * (3.0 - 2.0 * tone), 0.42);
}
