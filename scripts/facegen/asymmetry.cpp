#include "scripts/facegen/asymmetry.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace aucast::facegen {
namespace {

/// What a place of the face goes by.
Vec3 unevenness(const Askew& askew, const Vec3& p) {
  if (p.z < 2) return Vec3{0};
  const Vec3 brow{(p.x - 2.1) / 1.7, (p.y - 4.6) / 0.95, 0};
  const Vec3 mouth{(p.x - 1.5) / 1.3, (p.y + 2.3) / 1.2, 0};
  const Vec3 nose{p.x / 1.3, (p.y + 0.1) / 1.3, 0};
  const Vec3 chin{p.x / 2.6, (p.y + 4.7) / 1.8, 0};
  return smooth_step(2.0, 4.5, p.z) *
         (Vec3{0, askew.brow, 0} * (bell(brow) * smooth_step(3.3, 4.1, p.y)) +
          Vec3{0.3, 1, 0} * (askew.mouth * bell(mouth)) + Vec3{askew.nose, 0, 0} * bell(nose) +
          Vec3{askew.chin, 0, 0} * bell(chin));
}

bool stays(std::string_view name) {
  constexpr std::array<std::string_view, 7> kStay{
      "left_eye", "right_eye", "upper_teeth", "lower_teeth", "tongue", "hair", "shirt"};
  return std::find(kStay.begin(), kStay.end(), name) != kStay.end();
}

}  // namespace

void make_uneven(const Askew& askew, std::vector<Part>& parts) {
  for (Part& part : parts) {
    if (stays(part.name)) continue;
    for (Vertex& vertex : part.vertices) vertex.position += unevenness(askew, vertex.position);
  }
}

}  // namespace aucast::facegen
