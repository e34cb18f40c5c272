// What depends smoothly on the surface is worked out per vertex: sky, ground, fill and its
// highlight.

invariant gl_Position;  // the depth pass before must agree to the last bit

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in vec2 a_occlusion_gloss;
#ifndef EYE
layout(location = 4) in vec2 a_grain;  // goes with the surface
out vec2 v_grain;
#endif

uniform sampler2DShadow u_shadow_map;

#ifdef EYE
uniform vec3 u_eyeball_centre;
uniform vec3 u_eyeball_forward;
uniform float u_eyeball_open;  // 1: as wide as at rest, 0: shut
out vec3 v_position;
#endif
#ifdef HAIR
layout(location = 5) in vec4 a_strand;  // xyz: along the strand; w: across the hair
out vec4 v_strand;
#endif
out vec3 v_view;
out vec3 v_normal;
out vec4 v_colour;
out vec3 v_ambient;
out vec3 v_shine;  // occlusion, strength of the key's highlight, the fill's highlight
out float v_key;  // how much of the key arrives past what casts a shadow

const float kShadowLift = 0.06;   // along the normal, against a surface shading itself
const float kShadowStep = 0.009;  // share of the map's side

// The edge of a shadow is as soft as a large lamp's and wider than the distance between vertices:
// a wide filter per vertex costs half as much as a narrow one per pixel, and no texel shows.
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
const float kCorneaEnd = 1.3;      // radians from where the eye looks
const float kCorneaWidens = 0.94;  // below 1, so that no two points change places
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
  vec3 arriving = vec3(pow(max(occlusion, 1e-4), 0.82), occlusion, occlusion);
  v_ambient = arriving * ambient_light(a_normal);
#ifdef EYE
  v_position = place;
#else
  v_grain = a_grain;
#endif
#ifdef HAIR
  v_strand = a_strand;
#endif
  v_view = normalize(u_eye - place);
  v_normal = a_normal;
  v_colour = a_colour;
#ifdef SURFACE
  // Brows thin out where the skin turns away: seen along it their inner ends are a hook.
  v_colour.a *= mix(1.0, smoothstep(0.05, 0.58, abs(dot(a_normal, v_view))), u_thinning);
#endif
  v_key = key_arriving((u_world_to_shadow * vec4(place + a_normal * kShadowLift, 1.0)).xyz);
  v_ambient *= mix(1.0, v_key, u_enclosed);
  float specular = u_specular * a_occlusion_gloss.y;
  float across = dot(a_normal, normalize(kFillDirection + v_view));
  v_shine = vec3(occlusion, specular * (0.4 + 0.6 * occlusion),
                 0.25 * specular * exp(u_power * (across - 1.0)) * occlusion);
  gl_Position = u_world_to_clip * vec4(place, 1.0);
}
