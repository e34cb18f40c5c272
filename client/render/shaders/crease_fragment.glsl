// Lines multiply what is there, so that they suit every skin: by how much more or less light the
// slopes of the fold get than the smooth skin, and by what is lost in its ground.

in vec3 v_position;
in vec3 v_lost;
in vec2 v_relief;
out vec4 o_colour;

const float kSteep = 0.62;      // how far a slope tilts
const float kHalfWidths = 4.0;  // across a ribbon
const float kBulgeEnd = -2.1;   // where it begins

const float kFarSlope = 0.40;   // how steep the slope that faces the bulge is

// Skin scatters red light into the shade of its folds: without it they are grey or green.
const vec3 kScatter = vec3(0.78, 1.0, 1.06);

// Slope of the fold at `s` half widths from its ground: a groove, and beside it a bulge. Skin hangs
// over a fold from the side of the bulge and runs flat out of it on the other: a groove with two
// like slopes, one of which is lit, is a scar.
float slope_at(float s) {
  float groove = s / 0.50;
  float bulge = (s + 1.05) / 0.62;
  float steep = groove > 0.0 ? kFarSlope : 1.0;
  return 1.55 * steep * groove * exp(-groove * groove) - 0.75 * bulge * exp(-bulge * bulge);
}

vec3 light_on(vec3 normal) {
  return key_share(normal) * kKeyColour * u_key_strength + ambient_light(normal);
}

void main() {
  vec3 right = dFdx(v_position);
  vec3 up = dFdy(v_position);
  vec3 normal = normalize(cross(right, up));
  vec3 uphill = dFdx(v_relief.x) * cross(up, normal) + dFdy(v_relief.x) * cross(normal, right);
  uphill *= inversesqrt(max(dot(uphill, uphill), 1e-20));
  float slope = kSteep * v_relief.y * slope_at(kHalfWidths * v_relief.x + kBulgeEnd);
  vec3 factor = light_on(normalize(normal - slope * uphill)) / light_on(normal);
  factor = pow(factor, kScatter) - v_lost;
  // For blending source x destination twice: half is no change. The square root as in to_screen().
  o_colour = vec4(0.5 * sqrt(clamp(factor, 0.0, 4.0)), 0.5);
}
