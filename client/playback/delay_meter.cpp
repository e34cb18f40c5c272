#include "client/playback/delay_meter.h"

#include <algorithm>

namespace aucast::playback {
namespace {

constexpr std::size_t kMsMax = 10'000;
constexpr std::size_t kLately = 256;

}  // namespace

void DelayMeter::add(Duration delay) {
  if (by_ms_.empty()) by_ms_.resize(kMsMax + 1);
  const auto ms = std::chrono::round<Milliseconds>(delay).count();
  ++by_ms_[std::min(static_cast<std::size_t>(std::max<Milliseconds::rep>(ms, 0)), kMsMax)];
  ++keyframes_;
  longest_ = std::max(longest_, delay);
  if (last_.size() < kLately) {
    last_.push_back(delay);
  } else {
    last_[next_] = delay;
    next_ = (next_ + 1) % kLately;
  }
}

DelaySummary DelayMeter::all() const {
  DelaySummary summary{keyframes_, {}, longest_};
  std::uint64_t passed = 0;
  for (std::size_t ms = 0; ms < by_ms_.size(); ++ms) {
    passed += by_ms_[ms];
    if (2 * passed < keyframes_ || passed == 0) continue;
    summary.median = Milliseconds(ms);
    break;
  }
  return summary;
}

DelaySummary DelayMeter::lately() const {
  if (last_.empty()) return {};
  std::vector<Duration> sorted = last_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const Duration median = std::chrono::round<Milliseconds>(*middle);
  return {last_.size(), median, *std::max_element(middle, sorted.end())};
}

}  // namespace aucast::playback
