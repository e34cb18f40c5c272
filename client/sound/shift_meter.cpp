#include "client/sound/shift_meter.h"

#include <algorithm>
#include <cstddef>

namespace aucast::sound {
namespace {

constexpr Duration kBin = std::chrono::microseconds(100);
constexpr Duration kShiftMax = std::chrono::seconds(1);
constexpr std::size_t kBins = 2 * (kShiftMax / kBin) + 1;

}  // namespace

void ShiftMeter::add(Duration shift) {
  if (bins_.empty()) bins_.resize(kBins);
  const Duration from_most = std::clamp(shift, -kShiftMax, kShiftMax) + kShiftMax + kBin / 2;
  ++bins_[static_cast<std::size_t>(from_most / kBin)];
  ++count_;
}

Duration ShiftMeter::below(double part) const {
  const double wanted = part * static_cast<double>(count_);
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    sum += bins_[bin];
    if (static_cast<double>(sum) >= wanted) {
      return kBin * static_cast<Duration::rep>(bin) - kShiftMax;
    }
  }
  return kShiftMax;
}

ShiftSummary ShiftMeter::summary() const {
  if (count_ == 0) return {};
  return {count_, below(0.5), below(0.05), below(0.95)};
}

}  // namespace aucast::sound
