#include "client/gui/model/au_curves.h"

#include <algorithm>

namespace aucast::gui {

AuCurves curves_of(const playback::KeyframeList& keyframes) {
  AuCurves all(kAuCount);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const AuFrame aus = keyframes.aus(i);
    for (std::size_t number = 0; number < kAuCount; ++number) {
      const float value = std::max(aus.left[number], aus.right[number]);
      if (value <= 0) continue;
      std::vector<float>& values = all[number].values;
      if (values.empty()) values.resize(keyframes.size());
      values[i] = value;
    }
  }
  AuCurves curves;
  for (std::size_t number = 0; number < kAuCount; ++number) {
    if (all[number].values.empty()) continue;
    curves.push_back({static_cast<int>(number), std::move(all[number].values)});
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
