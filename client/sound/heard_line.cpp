#include "client/sound/heard_line.h"

#include <algorithm>

namespace aucast::sound {
namespace {

constexpr Duration kLookedBack = std::chrono::seconds(1);
/// Over less than this the readings' own jitter is more than a drift.
constexpr Duration kDriftOver = std::chrono::seconds(10);
/// A reading this far from the others is a leap of the device.
constexpr Duration kClockLeap = std::chrono::milliseconds(80);
/// What the line may run faster or slower by: a hundredth, and a tenth until there are readings of
/// half a second.
constexpr int kBendPart = 100;
constexpr int kFirstBendPart = 10;

}  // namespace

Duration HeardLine::mean() const {
  return sum_ / static_cast<Duration::rep>(readings_.size());
}

void HeardLine::begin_again() {
  readings_.clear();
  sum_ = Duration::zero();
  stood_ = said_;
  drift_from_.reset();
}

void HeardLine::add(Instant now, Duration heard) {
  said_ = heard;
  if (readings_.empty()) {
    if (heard <= stood_) return;
    begin_ = now;
    ahead_ = heard;
    last_at_ = now;
  }
  const Duration ahead = heard - (now - begin_);
  if (!readings_.empty() && std::chrono::abs(ahead - mean()) > kClockLeap) {
    begin_again();
    return;
  }
  readings_.push_back({now, ahead});
  sum_ += ahead;
  while (now - readings_.front().at > kLookedBack) {
    sum_ -= readings_.front().ahead;
    readings_.pop_front();
  }
}

Duration HeardLine::at(Instant now) {
  if (readings_.empty()) return last_;
  const bool settled = now - begin_ > kLookedBack / 2;
  const Duration bend = (now - last_at_) / (settled ? kBendPart : kFirstBendPart);
  ahead_ += std::clamp(mean() - ahead_, -bend, bend);
  last_at_ = now;
  if (!drift_from_ && now - begin_ > 2 * kLookedBack) drift_from_ = {now, ahead_};
  last_ = std::max(last_, now - begin_ + ahead_);
  return last_;
}

std::optional<double> HeardLine::drift_ppm() const {
  if (!drift_from_ || last_at_ - drift_from_->at < kDriftOver) return std::nullopt;
  return 1e6 * seconds(ahead_ - drift_from_->ahead) / seconds(last_at_ - drift_from_->at);
}

}  // namespace aucast::sound
