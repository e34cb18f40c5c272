#include "client/gui/model/au_curves.h"

#include <algorithm>

namespace aucast::gui {

AuCurves curves_of(std::span<const playback::Keyframe> keyframes) {
  AuCurves curves;
  for (std::size_t number = 0; number < AuFrame{}.left.size(); ++number) {
    AuCurve curve{static_cast<int>(number), {}};
    curve.values.reserve(keyframes.size());
    bool occurs = false;
    for (const playback::Keyframe& keyframe : keyframes) {
      const float value = std::max(keyframe.aus.left[number], keyframe.aus.right[number]);
      occurs |= value > 0;
      curve.values.push_back(value);
    }
    if (occurs) curves.push_back(std::move(curve));
  }
  return curves;
}

float value_at(const AuCurve& curve, const std::vector<Duration>& ends, Duration place) {
  const auto next = std::lower_bound(ends.begin(), ends.end(), place);
  if (next == ends.end()) return curve.values.empty() ? 0 : curve.values.back();
  const auto index = static_cast<std::size_t>(next - ends.begin());
  const Duration begin = index == 0 ? Duration::zero() : ends[index - 1];
  const float before = index == 0 ? 0 : curve.values[index - 1];
  const Duration length = *next - begin;
  if (length <= Duration::zero()) return curve.values[index];
  const auto share = static_cast<float>(seconds(place - begin) / seconds(length));
  return before + std::clamp(share, 0.0F, 1.0F) * (curve.values[index] - before);
}

std::vector<float> outline_of(const AuCurve& curve, const std::vector<Duration>& ends,
                              std::size_t columns) {
  std::vector<float> outline(columns);
  if (ends.empty()) return outline;
  const Duration total = ends.back();
  const auto count = static_cast<Duration::rep>(columns - 1);
  std::size_t keyframe = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    const Duration place = total * static_cast<Duration::rep>(i) / count;
    outline[i] = value_at(curve, ends, place);
    for (; keyframe < ends.size() && ends[keyframe] <= place; ++keyframe) {
      outline[i] = std::max(outline[i], curve.values[keyframe]);
    }
  }
  return outline;
}

}  // namespace aucast::gui
