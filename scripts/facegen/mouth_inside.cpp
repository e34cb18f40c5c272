#include "scripts/facegen/mouth_inside.h"

#include "scripts/facegen/palette.h"
#include "scripts/facegen/polyline.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {
namespace {

constexpr std::size_t kTeethPerSide = 7;

/// One jaw's arch of teeth. The lower one lies behind the upper, well inside the fold under the
/// lip, and leaves a gap to it, as with everybody who is not biting.
struct Arch {
  double up = 1;  ///< away from the bite: 1 for the upper jaw, -1 for the lower
  double half_width = 0;
  double length = 0;
  double gum_y = 0;  ///< where crowns begin
  double lean = 0;   ///< how far the edges stand before the necks
  std::array<double, kTeethPerSide> widths{};
  std::array<double, kTeethPerSide> heights{};
};

constexpr Arch kUpperArch{1,
                          2.05,
                          3.06,
                          -1.58,
                          0.04,
                          {.63, .46, .53, .49, .49, .68, .64},
                          {.925, .81, .83, .745, .66, .56, .48}};
constexpr Arch kLowerArch{-1,
                          2.02,
                          2.90,
                          -3.27,
                          0.12,
                          {.41, .44, .49, .49, .49, .70, .64},
                          {.66, .66, .67, .64, .60, .54, .51}};
constexpr double kArchBack = 4.8;
/// Squarer than an ellipse (2): a narrow front ends in a dark gap to the corner of the mouth.
constexpr double kArchPower = 2.10;

/// The arch as a polyline, to walk along it by length.
class ArchCurve {
 public:
  explicit ArchCurve(const Arch& arch) : half_width_(arch.half_width), length_(arch.length) {
    constexpr int kSteps = 600;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = static_cast<double>(i) / kSteps * kPi / 2;
      points_.push_back(at_angle(angle));
    }
  }

  [[nodiscard]] Vec3 at_angle(double angle) const {
    const double x = std::copysign(power(std::abs(std::sin(angle)), 2 / kArchPower), angle);
    const double z = power(std::max(0.0, std::cos(angle)), 2 / kArchPower);
    return {half_width_ * x, 0, kArchBack + length_ * z};
  }

  /// The point `way` from the middle.
  [[nodiscard]] Vec3 at(double way) const { return Polyline(points_).at_length(way); }

 private:
  double half_width_;
  double length_;
  std::vector<Vec3> points_;
};

/// Where crowns meet, light gets lost; more would draw black bars.
constexpr Vec3 kLostBetweenTeeth{0.20, 0.28, 0.33};

/// No two teeth of a row have one colour: canines are the darkest of the front and the most yellow,
/// and behind them light gets lost.
constexpr std::array<Vec3, kTeethPerSide> kCrownTint{{{1.0, 1.0, 1.0},
                                                      {0.97, 0.96, 0.95},
                                                      {0.92, 0.88, 0.82},
                                                      {0.88, 0.84, 0.79},
                                                      {0.82, 0.78, 0.73},
                                                      {0.75, 0.72, 0.68},
                                                      {0.70, 0.67, 0.63}}};

/// Seven columns of a crown, closer where it rounds off beside its neighbours.
constexpr std::array kAcrossCrown{0.0, 0.07, 0.23, 0.5, 0.77, 0.93, 1.0};

/// A measure of crowns at `u` of the width of one: neighbours meet at one height and thickness, or
/// the row looks torn, and in one tint, or they are keys.
template <typename Measure>
Measure of_crown(const std::array<Measure, kTeethPerSide>& measure, std::size_t tooth, double u) {
  const Measure own = measure[tooth];
  const std::size_t towards =
      u < 0.5 ? (tooth == 0 ? 0 : tooth - 1) : std::min(tooth + 1, kTeethPerSide - 1);
  return mix(own, (own + measure[towards]) * 0.5, std::abs(2 * u - 1));
}

/// `to_tip` from the gum to the edge, `u` of the width of the crown.
Vec3 tooth_colour(double to_tip, double u, std::size_t tooth) {
  const double across = std::abs(2 * u - 1);
  Vec3 c = mix(kToothNeck, kTooth, smooth_step(0, 0.6, to_tip)) * of_crown(kCrownTint, tooth, u) *
           (Vec3{1} - kLostBetweenTeeth * power(across, 6));
  // The edge is thin: what shows through is the dark of the mouth, and little red.
  if (tooth < 2) c *= mix(Vec3{1}, Vec3{0.80, 0.82, 0.86}, smooth_step(0.80, 1.0, to_tip));
  return to_tip < 0.06 ? mix(c, kGum, 0.5) : c;
}

/// How much of its edge a front tooth loses beside its neighbours, towards the middle and away from
/// it: canines are pointed.
constexpr std::array<std::array<double, 2>, 3> kRounding{
    {{0.035, 0.08}, {0.07, 0.10}, {0.10, 0.12}}};

/// How thick crowns are, in those of the front.
constexpr std::array<double, kTeethPerSide> kThickness{1, 1, 1.15, 1.4, 1.5, 1.6, 1.6};

/// How one tooth of the front stands otherwise than its row: no two do alike, or they are a
/// denture.
struct Stand {
  double turn = 0;     ///< how much further forward its far end stands than its near one
  double forward = 0;  ///< all of it
  double longer = 0;   ///< its edge
  double tint = 1;     ///< of its colour
};
/// On the subject's right, then on the left.
constexpr std::array<std::array<Stand, kTeethPerSide>, 2> kStands{{{{{-0.015, 0, 0, 1},
                                                                     {0.04, -0.02, -0.009, 0.965},
                                                                     {-0.025, 0.013, -0.002, 0.986},
                                                                     {0.015, -0.01, 0.005, 1},
                                                                     {0, 0, -0.005, 0.972},
                                                                     {},
                                                                     {}}},
                                                                   {{{0.01, 0.007, -0.004, 0.986},
                                                                     {-0.03, 0.005, 0.007, 0.986},
                                                                     {0.03, -0.007, -0.007, 0.951},
                                                                     {-0.015, 0.01, -0.005, 0.972},
                                                                     {0, 0, 0.005, 1},
                                                                     {},
                                                                     {}}}}};
/// The lower incisors crowd more than the upper ones.
constexpr double kCrowding = 1.5;

/// One row of a crown: how far from the gum to the edge, and how far behind its front.
struct CrownRow {
  double v = 0;
  double behind = 0;
};
/// Down the front, over the edge and up the back: what is seen from above or from the side must be
/// a body too, a sheet looks like paper.
constexpr std::array<CrownRow, 10> kCrownRows{{{0, 0},
                                               {0.17, 0},
                                               {0.36, 0},
                                               {0.56, 0},
                                               {0.75, 0},
                                               {0.90, 0},
                                               {1.0, 0.03},
                                               {0.98, 0.15},
                                               {0.62, 0.28},
                                               {0, 0.40}}};

/// What is left of the light behind the front teeth, and the colour far behind them: little and
/// warm, for it comes off tongue and gums.
constexpr Vec3 kCrownBack{0.62, 0.48, 0.42};
constexpr Vec3 kCrownFarBack{0.36, 0.20, 0.165};

/// A crown from `begin` along the arch, on the side of the sign of `side`.
void add_tooth(Part& part, const Arch& arch, const ArchCurve& curve, std::size_t tooth,
               double begin, int side) {
  const bool molar = tooth > 2;
  const double lean = molar ? 0.02 : arch.lean;
  // The lower row has what the other side of the upper one has.
  const Stand& stand = kStands[(side > 0) == (arch.up > 0) ? 1 : 0][tooth];
  const double crowding = arch.up > 0 ? 1 : kCrowding;
  std::vector<std::uint32_t> above;
  for (std::size_t j = 0; j < kCrownRows.size(); ++j) {
    const auto& [v, behind] = kCrownRows[j];  // gum to edge and back
    std::vector<std::uint32_t> row;
    for (const double u : kAcrossCrown) {
      const double across = std::abs(2 * u - 1);
      const double tapered = 0.5 + (u - 0.5) * (1 - 0.05 * (1 - v));
      const double width = arch.widths[tooth] + 0.03;
      const Vec3 base = curve.at(begin - 0.015 + width * tapered);
      const Vec3 out = glm::normalize(Vec3{base.x / 2.0, 0, (base.z - 4.9) / 3.0});
      const double bulge = 0.10 * (1 - power(across, 4)) * (1 - 0.3 * v);
      const double edge = -0.035 * power(across, 8) - 0.10 * power(v, 8);
      const double depth = behind * of_crown(kThickness, tooth, u);
      const double aside = crowding * (stand.forward + stand.turn * (u - 0.5)) * (0.4 + 0.6 * v);
      Vec3 p = base + out * (bulge + edge - depth + lean * v + aside);
      const double height = of_crown(arch.heights, tooth, u);
      // Their corners are round, most those away from the middle; a deep notch between the first
      // two would be a black dot.
      const double notch =
          (molar ? 0.03 : kRounding[tooth][u < 0.5 ? 0 : 1]) * power(across, 4) * v * v;
      const double toward_bite = (height + stand.longer) * v - notch;
      p.y = arch.gum_y - arch.up * toward_bite;
      p.x *= side;
      const double in_shade = smooth_step(0.0, 0.16, behind);
      const Vec3 front = tooth_colour(v, u, tooth) * stand.tint;
      // The lower row is seen from behind past the lip: lit, its backs would be a heap of shells.
      const Vec3 near_back = arch.up > 0 ? front * kCrownBack : kCrownFarBack;
      const Vec3 back = mix(kCrownFarBack, near_back, smooth_step(5.8, 7.4, p.z));
      row.push_back(part.add(p, mix(front, back, in_shade)));
      part.vertices.back().occlusion = mix(1.0, 0.05, in_shade);
      part.vertices.back().gloss = mix(1.0, 0.1, in_shade);
    }
    if (j > 0) {
      const bool left_to_right = (side > 0) == (arch.up > 0);
      if (left_to_right) {
        part.add_band(row, above, false);
      } else {
        part.add_band(above, row, false);
      }
    }
    above = std::move(row);
  }
}

/// The gum from before the teeth over its ridge and back into the mouth.
void add_gum(Part& part, const Arch& arch, const ArchCurve& curve) {
  constexpr int kSteps = 40;
  static constexpr std::array kHeights{0.55, 0.28, 0.05, -0.06, -0.12, -0.02, 0.30, 0.80};
  static constexpr std::array kOut{-0.30, 0.0, 0.05, -0.10, -0.55, -0.74, -0.88, -1.10};
  std::vector<std::uint32_t> above;
  for (std::size_t k = 0; k < kHeights.size(); ++k) {
    std::vector<std::uint32_t> row;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = -kPi / 2 + kPi * i / kSteps;
      const Vec3 out{std::sin(angle), 0, std::cos(angle)};
      Vec3 p = curve.at_angle(angle) + out * kOut[k];
      p.y = arch.gum_y + arch.up * kHeights[k];
      row.push_back(part.add(p, mix(kGum, kGumBack, smooth_step(-0.5, -1.1, kOut[k]))));
      if (k >= 4) part.vertices.back().occlusion = 0.1;
    }
    if (k > 0) {
      if (arch.up > 0) {
        part.add_band(row, above, false);
      } else {
        part.add_band(above, row, false);
      }
    }
    above = std::move(row);
  }
}

/// How far behind the lips: 1 in the middle of the front teeth, 0 in the corners of the mouth and
/// behind. The lips darken what they cover, also where they part. Not baked: with the mouth shut
/// all is black.
double light_behind_lips(const Vec3& p) {
  return smooth_step(4.9, 7.6, p.z) * smooth_step(2.25, 0.40, std::abs(p.x));
}

constexpr Vec3 kLightOnLowerTeeth{0.84, 0.76, 0.69};
/// What is seen of the lower row behind its front: the colour of the walls there, not a grey block.
constexpr Vec3 kLowerRowBehind{0.33, 0.105, 0.088};

void shade_teeth(Part& teeth, const Arch& arch) {
  for (Vertex& vertex : teeth.vertices) {
    const double light = light_behind_lips(vertex.position);
    vertex.occlusion *= mix(0.25, 1.0, light);
    // The shadow of the lip that covers their necks.
    const double from_gum = arch.up * (arch.gum_y - vertex.position.y);
    // Blue goes first on the way to the back, or teeth in the shade are grey.
    const Vec3 arriving{light, power(light, 1.05), power(light, 1.14)};
    vertex.colour *= mix(Vec3{0.27, 0.15, 0.11}, Vec3{1}, arriving) *
                     (arch.up > 0 ? mix(0.52, 1.25, smooth_step(0.34, 0.90, from_gum))
                                  : mix(0.90, 1.26, smooth_step(0.10, 0.90, from_gum)));
    // The lower row lies in the shade of the upper one, where no rim light gets.
    if (arch.up < 0) {
      // Its end seen past the tongue would be a grey block, and its far side a black one.
      const double far = std::max(smooth_step(7.3, 6.2, vertex.position.z),
                                  smooth_step(0.45, 1.10, std::abs(vertex.position.x)));
      vertex.colour = mix(vertex.colour * kLightOnLowerTeeth, kLowerRowBehind, far);
      vertex.occlusion = mix(std::max(vertex.occlusion * 0.5, 0.3), 0.25, far);
    }
    vertex.gloss *= mix(0.2, 1.0, light);
  }
}

/// Light gets to the tip of the tongue, not to the throat nor to its sides; no more of the ambient
/// light than that, or the rim lights draw a blue haze over what is seen so flatly.
void shade_tongue(Part& tongue) {
  for (Vertex& vertex : tongue.vertices) {
    const Vec3& p = vertex.position;
    vertex.occlusion = mix(0.15, 0.85, smooth_step(5.0, 7.0, p.z));
    vertex.gloss = mix(0.1, 2.6, smooth_step(5.9, 6.9, p.z));
    vertex.colour *= mix(0.34, 1.6, smooth_step(4.9, 7.2, p.z)) *
                     mix(0.62, 1.0, smooth_step(1.30, 0.50, std::abs(p.x))) *
                     (1 - 0.36 * bell(p.x, 0.17) * smooth_step(7.4, 6.9, p.z));
  }
}

/// How a ring of the mouth's inside differs from the line of the lips that it begins at.
struct BagRing {
  double back;      ///< share of the way to the throat
  double widen;     ///< factor on x
  double heighten;  ///< factor on y about the line of the mouth
  double least;     ///< height above the line of the mouth, round the rows of teeth
  double below;     ///< the same below it: under the gum, between lip and teeth
  double muscle;    ///< how far it goes with the lips and cheeks that it lines
};

struct LipPlace {
  std::uint32_t vertex;
  int up;         ///< 1 for the upper lip, -1 for the lower, 0 in the corners
  double corner;  ///< from 1 in the corners to 0 a few spokes away
};

constexpr double kMiddleY = -2.45;  ///< of the line of the mouth

/// The innermost ring of the lips, once round.
std::vector<LipPlace> lip_loop(const Skin& skin) {
  std::vector<LipPlace> loop;
  const auto go_by = [&](int s, int side) {
    const int up = s == kMouthCornerSpoke ? 0 : s < kMouthCornerSpoke ? 1 : -1;
    const double corner = smooth_step(6.0, 0.0, std::abs(s - kMouthCornerSpoke));
    loop.push_back({skin.find(Patch::Mouth, kLipLastRing, s, side), up, corner});
  };
  for (int s = 0; s < kMouthSpokes; ++s) go_by(s, 1);
  for (int s = kMouthSpokes - 2; s > 0; --s) go_by(s, -1);
  return loop;
}

/// A ring just outside the first one of the bag: between skin and bag, single pixels would show
/// what lies behind the head.
std::vector<std::uint32_t> add_skirt(Part& bag, const Skin& skin,
                                     const std::vector<LipPlace>& loop) {
  std::vector<std::uint32_t> skirt;
  for (const LipPlace& place : loop) {
    const Vertex& lip = skin.part.vertices[place.vertex];
    const Vec3 from_middle = lip.position - Vec3{0, kMiddleY, lip.position.z};
    skirt.push_back(bag.add(lip.position + glm::normalize(from_middle) * 0.05 + Vec3{0, 0, 0.08},
                            bag.vertices[skirt.size()].colour));
    bag.vertices.back().maps = lip.maps;
    bag.vertices.back().occlusion = 0;
    bag.vertices.back().gloss = 0;
  }
  return skirt;
}

}  // namespace

Part make_teeth(Jawbone jawbone) {
  const bool upper = jawbone == Jawbone::Upper;
  const Arch& arch = upper ? kUpperArch : kLowerArch;
  Part teeth;
  teeth.name = upper ? "upper_teeth" : "lower_teeth";
  teeth.material = face::Material::Teeth;
  const ArchCurve curve(arch);
  for (const int side : {-1, 1}) {
    double begin = 0.01;
    for (std::size_t tooth = 0; tooth < kTeethPerSide; ++tooth) {
      add_tooth(teeth, arch, curve, tooth, begin, side);
      begin += arch.widths[tooth];
    }
  }
  add_gum(teeth, arch, curve);
  shade_teeth(teeth, arch);
  teeth.fill(Map::Head, 1);
  teeth.fill(Map::Jaw, upper ? 0 : 1);
  return teeth;
}

Part make_tongue() {
  constexpr int kAround = 20;
  constexpr int kAlong = 12;
  Part tongue;
  tongue.name = "tongue";
  tongue.material = face::Material::Mouth;
  std::vector<std::uint32_t> front;
  for (int j = 0; j <= kAlong; ++j) {
    const double b = kPi * j / kAlong;  // tip to root
    const double z = 5.40 + 1.95 * std::cos(b);
    const double width = 1.14 * power(std::sin(b), 0.60) * (1 - 0.36 * std::cos(b));
    // Low, so that it fits between the lips and lies behind the lower teeth in an open mouth.
    const double height = power(std::sin(b), 0.6) * mix(0.60, 0.25, smooth_step(4.9, 7.25, z));
    std::vector<std::uint32_t> ring;
    for (int i = 0; i < kAround; ++i) {
      const double a = 2 * kPi * i / kAround;
      const double x = width * std::cos(a);
      double y = -3.10 + height * std::sin(a) - 0.10 * std::cos(b);
      if (std::sin(a) > 0) {
        // The groove ends before the root, or its silhouette is two humps.
        y -= 0.07 * bell(x, 0.20) * std::sin(b) * smooth_step(4.4, 6.0, z);
      }
      y -= 0.0216 * (z - 5.5) * (z - 5.5);
      // Light falls on its back; its sides are in the shade of the rows of teeth.
      const double lit =
          mix(0.42, 1.15, std::max(smooth_step(0.0, 0.85, std::sin(a)), smooth_step(6.9, 7.3, z)));
      ring.push_back(tongue.add({x, y, z}, kTongue * lit));
    }
    if (j > 0) tongue.add_band(ring, front, true);
    front = std::move(ring);
  }
  shade_tongue(tongue);
  tongue.fill(Map::Head, 1);
  tongue.fill(Map::Jaw, 0.9);
  for (Vertex& vertex : tongue.vertices) {
    vertex[Map::Tongue] = smooth_step(3.9, 7.4, vertex.position.z);
  }
  return tongue;
}

Part make_mouth_bag(const Skin& skin) {
  static constexpr std::array<BagRing, 6> kRings{{{0, 1, 1, 0, 0, 1},
                                                  {.06, 1.06, 1.02, .1, 1.1, .8},
                                                  {.25, 1.26, 1.25, .5, 1.55, .7},
                                                  {.45, 1.42, 1.6, .8, 1.7, .6},
                                                  {.68, 1.45, 1.5, .8, 1.6, .4},
                                                  {.88, .9, .8, .5, .9, 0}}};
  constexpr double kThroatZ = 3.6;
  /// In the corners, ring by ring: the edge is dark, the walls close behind it are not.
  static constexpr std::array kCornerLight{0.50, 1.0, 0.85};
  const std::vector<LipPlace> loop = lip_loop(skin);
  Part bag;
  bag.name = "mouth_bag";
  bag.material = face::Material::Mouth;
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> front;
  Vec3 last_middle{0};
  for (std::size_t k = 0; k < kRings.size(); ++k) {
    const BagRing& shape = kRings[k];
    std::vector<std::uint32_t> ring;
    last_middle = Vec3{0};
    for (const LipPlace& place : loop) {
      const Vertex& lip = skin.part.vertices[place.vertex];
      double high = (lip.position.y - kMiddleY) * shape.heighten;
      if (place.up > 0) high = std::max(high, shape.least);
      const double below = mix(shape.below, std::min(shape.below, shape.least), place.corner);
      if (place.up < 0) high = std::min(high, -below);
      const Vec3 p{lip.position.x * shape.widen, kMiddleY + high,
                   mix(lip.position.z, kThroatZ, shape.back)};
      // Darker in the corners, where its edge is seen from the front: lit, it is a pale string. The
      // walls behind it are red for longer, that an open mouth ends in flesh and not in a black
      // wedge.
      const Vec3 front_colour = kMouthFront * mix(0.9, k == 0 ? 0.5 : 0.95, place.corner);
      const Vec3 colour =
          mix(front_colour, kMouthBack, smooth_step(0.0, mix(0.8, 0.95, place.corner), shape.back));
      ring.push_back(bag.add(p, colour));
      Vertex& vertex = bag.vertices.back();
      vertex.maps = lip.maps;
      // A trace, that the walls of the open mouth are red and not black; more, and the lights from
      // behind would draw them.
      const double at_corner = kCornerLight[std::min(k, kCornerLight.size() - 1)];
      vertex.occlusion = mix(0.75, at_corner, place.corner) * smooth_step(1.05, 0.25, shape.back);
      vertex.gloss = 0.04;
      if (k > 0) {
        vertex[Map::Muscle] *= shape.muscle;
        vertex[Map::Jaw] = mix(vertex[Map::Jaw], smooth_step(0.5, -0.8, p.y + 2.5), 0.5);
      }
      last_middle += p / static_cast<double>(loop.size());
    }
    if (k == 0) first = ring;
    if (k > 0) bag.add_band(ring, front, true);
    front = std::move(ring);
  }
  const std::uint32_t end = bag.add({0, last_middle.y, kThroatZ}, kMouthBack * 0.67);
  bag.vertices[end][Map::Jaw] = 0.3;
  bag.vertices[end][Map::Head] = 1;
  bag.vertices[end].occlusion = 0;
  bag.vertices[end].gloss = 0.04;
  bag.add_band(first, add_skirt(bag, skin, loop), true);
  for (std::size_t i = 0; i < front.size(); ++i) {
    bag.add_triangle(end, front[(i + 1) % front.size()], front[i]);
  }
  return bag;
}

}  // namespace aucast::facegen
