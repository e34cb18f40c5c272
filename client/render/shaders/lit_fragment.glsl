#ifdef EYE
in vec3 v_position;
uniform vec3 u_eyeball_centre;
uniform vec3 u_eyeball_forward;
uniform float u_eyeball_open;
#else
in vec2 v_grain;
#endif
#ifdef SURFACE
uniform sampler2D u_grain_map;
#endif
#ifdef HAIR
in vec4 v_strand;
#endif
in vec3 v_view;
in vec3 v_normal;
in vec4 v_colour;
in vec3 v_ambient;
in vec3 v_shine;
in float v_key;

out vec4 o_colour;

#ifdef HAIR
const float kStrands = 720.0;  // side by side round the head
const float kShineShift = 0.10;
const float kPieces = 8.0;  // of a strand, along the direction that v_grain counts

// How much shows of strands numbered by `at`: nothing where several share a pixel.
float fineness(float at) { return 1.0 - smoothstep(0.55, 1.6, fwidth(at)); }

uvec2 scatter(uvec2 n) {
  n = n * 747796405u + 2891336453u;
  n = ((n >> ((n >> 28u) + 4u)) ^ n) * 277803737u;
  return (n >> 22u) ^ n;
}

vec2 signed_share(uvec2 n) { return vec2(n) / 2147483648.0 - 1.0; }

// A fixed pseudo-random number in [-1, 1] for each whole number, smooth between them.
float strand_noise(float at) {
  vec2 value = signed_share(scatter(uvec2(floor(at) + vec2(0.0, 1.0))));
  return mix(value.x, value.y, smoothstep(0.0, 1.0, fract(at)));
}

// The same, changing along each strand at places of its own: a hair is seldom on top all its way.
float piece_noise(float at, float along) {
  uvec2 strand = scatter(uvec2(floor(at) + vec2(0.0, 1.0)));
  vec2 place = along + 64.0 + vec2(strand & 1023u) / 128.0;
  uvec2 piece = strand ^ (uvec2(place) * 1664525u);
  uvec2 next = strand ^ ((uvec2(place) + 1u) * 1664525u);
  vec2 value = mix(signed_share(scatter(piece)), signed_share(scatter(next)),
                   smoothstep(0.0, 1.0, fract(place)));
  value = 0.45 * signed_share(strand) + 0.75 * value;
  return mix(value.x, value.y, smoothstep(0.0, 1.0, fract(at)));
}

// The direction of the strands on a surface; downhill on one without strands.
vec3 strand_direction(vec3 normal) {
  vec3 along = v_strand.xyz - normal * dot(v_strand.xyz, normal);
  float length2 = dot(along, along);
  if (length2 < 1e-12) {
    along = vec3(0.0, -1.0, 0.0) + normal * normal.y;
    length2 = max(dot(along, along), 1e-4);
  }
  return along * inversesqrt(length2);
}

// Strands shine like wires: across themselves in every direction, so that the highlight becomes a
// band. A white one nearer to the roots and one in the colour of the hair nearer to the tips
// (Marschner 2003), each strand at its own place.
vec3 strand_shine(vec3 normal, vec3 along, vec3 view, vec3 colour, float strand, float key) {
  vec3 halfway = normalize(u_key_direction + view);
  vec3 fill_halfway = normalize(kFillDirection + view);
  // Locks differ as strands do, or the band would be drawn with a ruler.
  float astray = 0.18 * strand + 0.21 * strand_noise(v_strand.w * 60.0 + 7000.0);
  float tilt = dot(along, halfway) + astray;
  float up = tilt - kShineShift;
  float down = tilt + kShineShift;
  float fill_tilt = dot(along, fill_halfway) + astray;
  float lit = clamp(dot(normal, u_key_direction) + 0.3, 0.0, 1.0) * key;
  float fill_lit = clamp(dot(normal, kFillDirection) + 0.3, 0.0, 1.0);
  float broad = exp(-u_power * down * down);
  float narrow = exp(-4.0 * u_power * up * up);
  float filled = 0.3 * exp(-2.0 * u_power * fill_tilt * fill_tilt) * fill_lit;
  // Most of the hue of the hair: plain white makes brown hair look dusty.
  vec3 white = 0.3 + 0.7 * colour / max(max(colour.r, colour.g), max(colour.b, 0.01));
  vec3 shine = 1.9 * colour * (broad * lit + filled) +
               0.24 * white * (narrow * max(1.0 + 1.7 * strand, 0.0) * lit);
  // Not at the very outline, where single pixels would sparkle.
  // White hairs are coarse and dull.
  return shine * smoothstep(0.0, 0.3, dot(normal, view)) * (1.0 - 0.40 * u_grey);
}

// How light the strand here is, in [-1, 1], and so its colour: single ones and, about four times as
// wide, tufts. Strands of an edge end at different places: `cover` is what is left of them. The
// outline is such an edge; `facing` is 0 there.
float strand_here(inout vec3 colour, out float cover, float facing) {
  float at = v_strand.w * kStrands;
  // One colour shows in longer pieces than white hairs among dark ones.
  float grey = at > 0.0 ? u_grey : 0.0;  // bare clay has neither
  float pieces = mix(0.3, 1.0, grey) * kPieces;
  float along = at > 0.0 ? (v_grain.y - v_grain.x) * pieces : 0.0;
  float visible = fineness(at);
  float fine = piece_noise(at, along) * visible;
  float tuft = strand_noise(at * 0.27 + 5000.0) * fineness(at * 0.27);
  // A tuft does not stay light or dark from root to tip.
  float turn = sin(6.0 * v_grain.y + 6.0 * strand_noise(at * 0.06 + 9000.0));
  tuft *= turn;
  cover = 1.0;
  if (v_colour.a < 1.0) {
    // Not the noise of the colour, or the longest strands would be the dark ones.
    float length_here = piece_noise(at * 1.6 + 3000.0, along * 2.5) * visible;
    float cut = 0.5 + 0.45 * length_here + 0.12 * tuft;
    float soft = mix(0.5, mix(0.26, 0.38, u_grey), visible);
    cover = smoothstep(cut - soft, cut + soft, mix(-0.7, 1.7, v_colour.a));
  }
  // Seen along it the outside ends strand by strand, at places of their own.
  float outline =
      0.5 + 0.5 * piece_noise(at * 0.16 + 700.0, 0.6 * (v_grain.y - v_grain.x) * kPieces);
  cover *= smoothstep(0.0, 0.10, facing - mix(0.11, 0.06, u_grey) * outline * outline);
  float strand = 0.55 * (fine + (1.0 - 0.5 * grey) * tuft);
  colour *= 1.0 + mix(0.52, 0.42, grey) * strand;
  // White hairs are whole ones, not lighter places of all.
  colour = mix(colour, vec3(0.27, 0.25, 0.23), 0.24 * grey * smoothstep(0.15, 0.95, fine));
  // Locks: some lie deeper than others, and between them it is dark.
  float lock = strand_noise(at * 0.055 + 12000.0 + 0.5 * tuft);
  lock *= 0.75 + 0.25 * turn;
  float deep = 1.0 - abs(lock);
  float locks = mix(0.24, 0.30, grey) * lock - mix(0.32, 0.36, grey) * deep * deep * deep * deep;
  // The lighter ones are the ones that the sun has bleached: less red.
  vec3 bleached = mix(vec3(1.0), vec3(0.97, 1.04, 1.12), lock * (1.0 - grey));
  colour *= at > 0.0 ? (1.0 + locks) * bleached : vec3(1.0);
  return strand;
}
#endif

// What the key gives a surface; `arriving` is how much of it no shadow takes.
vec3 key_light(vec3 normal, float occlusion, out float arriving) {
  float towards_key = dot(normal, u_key_direction);
  // Where the surface turns away from the key it is its own shadow; the map would only draw its
  // texels there.
  arriving = mix(1.0, v_key, smoothstep(-0.36, 0.0, towards_key));
  vec3 through = mix(u_shadow_kept, vec3(1.0), arriving);
  return key_share(normal) * through * kKeyColour * (u_key_strength * (0.42 + 0.58 * occlusion));
}

#ifdef SURFACE
const float kRelief = 0.33;  // how far pores tilt what has grain
#endif

#ifdef EYE
const vec2 kCatchlight = vec2(0.051, 0.058);  // half its sides, of the ball's radius

vec3 with_reflections(vec3 lit, vec3 view, vec3 normal) {
  // Reflections of a window where a portrait painter puts them: true ones hide behind the lids as
  // soon as the head turns, and the eyes look dead.
  vec3 side = normalize(vec3(view.z, 0.0, -view.x));
  vec3 up = cross(view, side);
  // They stay on the iris also in profile, or the eye is a painted ball.
  float sideways = smoothstep(0.1, 0.8, 1.0 - dot(view, u_eyeball_forward));
  vec3 middle = mix(view, u_eyeball_forward, 0.82);
  // The window stands near: each eye sees it from another place.
  float which = clamp(dot(u_eyeball_centre, side), -1.0, 1.0) * (1.0 - sideways);
  float aside = 0.105 * (1.0 - sideways) + 0.024 * which;
  // A lid that comes down does not put it out, but for one that follows the gaze.
  float looks_down = clamp(-3.0 * dot(u_eyeball_forward, up), 0.0, 1.0);
  float low = 0.30 * (1.0 - min(u_eyeball_open, 1.0)) * (1.0 - looks_down);
  float above = mix(0.120, 0.09, sideways) + 0.012 * which - low;
  vec3 first = normalize(middle - side * aside + up * above);
  vec3 second = normalize(middle + side * 0.17 - up * 0.20);
  // A window is square, lighter at its upper edge, and soft on a wet ball.
  vec3 off = normal - first;
  vec2 pane = vec2(dot(off, side), dot(off, up)) / (kCatchlight * (1.0 + 0.14 * which));
  vec2 pane2 = pane * pane;
  float window = exp(-0.35 * dot(pane2, pane2) - 0.75 * dot(pane, pane));
  lit = mix(lit, vec3(1.06, 1.05, 1.03), window * (0.92 + 0.08 * clamp(pane.y, -1.0, 1.0)));
  lit += vec3(0.060, 0.054, 0.048) * smoothstep(0.975, 0.999, dot(normal, second));
  // From the side the front of the cornea is clear: what lies behind it shows, not the pupil.
  float facing = 1.0 - max(dot(normal, view), 0.0);
  return mix(lit, vec3(0.40, 0.37, 0.35), 0.60 * sideways * smoothstep(0.62, 1.0, facing));
}
#endif

void main() {
  vec3 view = v_view;  // near enough to unit length between near vertices
  vec3 colour = v_colour.rgb;
  float occlusion = v_shine.x;
#ifdef EYE
  vec3 from_centre = v_position - u_eyeball_centre;
  vec3 normal = normalize(from_centre);
#else
  vec3 normal = normalize(v_normal);
#ifdef HAIR
  float cover;
  float strand = strand_here(colour, cover, abs(dot(normal, view)));
  vec3 along = strand_direction(normal);
#else
  normal = gl_FrontFacing ? normal : -normal;
  vec4 grain = u_grain * (texture(u_grain_map, v_grain) - 128.0 / 255.0);
  // Its relief breaks up the shine: smooth skin is wax. The map lies across and up the front, and
  // the right half is the mirror of the left one.
  float across = dFdx(v_grain.x) < 0.0 ? -grain.b : grain.b;
  normal = normalize(normal + kRelief * vec3(across, grain.a, 0.0));
  colour *= 1.0 + grain.r * vec3(0.16, 0.25, 0.28);  // more blood or less: red changes least
#endif
#endif

  float arriving;
  vec3 result = colour * (key_light(normal, occlusion, arriving) + v_ambient);

#ifdef EYE
  // The upper lid and its lashes shade the ball below them.
  result *= mix(vec3(1.0), vec3(0.40, 0.33, 0.31), smoothstep(-0.06, 0.48, from_centre.y));
  // The lower lid meets it in shade, or the ball is a wedge with a cut end.
  result *= mix(0.62, 1.0, smoothstep(-0.50, -0.12, from_centre.y));
  result = with_reflections(result, view, normal);
#else
#ifdef HAIR
  vec3 specular =
      strand_shine(normal, along, view, colour, strand, arriving * u_key_strength) * v_shine.y;
#else
  // exp(n (c - 1)) is cos to the n near its top, for half the work.
  vec3 halfway = u_key_direction + view;
  float aligned = dot(normal, halfway) * inversesqrt(dot(halfway, halfway));
  float broad = exp(u_power * (aligned - 1.0));
  float narrow = broad * broad * broad * broad;
  float shone = arriving * u_key_strength;
  float specular = (0.56 * broad + 0.44 * narrow) * shone * v_shine.y + v_shine.z;
#endif

  float facing = 1.0 - max(dot(normal, view), 0.0);
  // Never to the full: the last pixel of an ear would be a white thread.
  float edge = facing * facing;
  edge = min(edge * edge * sqrt(facing), 0.45);
  vec3 rim = kRimColour * (kRimStrength * max(dot(normal, kRimDirection) + 0.15, 0.0)) +
             kSecondRimColour *
                 (kSecondRimStrength * max(dot(normal, kSecondRimDirection) + 0.15, 0.0));
#ifdef HAIR
  result += specular + rim * (edge * occlusion * 0.18);
#else
  result += vec3(1.0, 0.98, 0.95) * (specular * max(1.0 + 1.9 * grain.g, 0.0)) +
            rim * (0.05 + 0.95 * colour) * (edge * occlusion * occlusion * occlusion);
#endif
#endif
#ifdef HAIR
  o_colour = vec4(to_film(result), cover);
#else
  o_colour = vec4(to_film(result), v_colour.a);
#endif
}
