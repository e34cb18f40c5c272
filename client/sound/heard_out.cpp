#include "client/sound/heard_out.h"

#include <algorithm>
#include <utility>

#include "client/sound/sound_track.h"

namespace aucast::sound {

void HeardOut::begin(Instant steady) {
  heard_at_ = steady;
  starved_ = written_ > 0;
  line_.begin_again();
}

void HeardOut::write(std::span<const float> samples) {
  out_->write(samples);
  written_ += static_cast<std::int64_t>(samples.size());
  starved_ = false;
}

/// What the device says may not go back, nor beyond what it was given.
std::int64_t HeardOut::report() const {
  return std::clamp(out_->heard(), heard_, written_);
}

bool HeardOut::look(Instant steady) {
  const std::int64_t heard = report();
  if (std::exchange(heard_, heard) != heard) heard_at_ = steady;
  line_.add(steady, time_of(heard));
  if (out_->lost() || steady - heard_at_ > kDeafMax) return false;
  if (heard_ == written_ && !starved_ && written_ > 0) {
    starved_ = true;
    ++underruns_;
    line_.begin_again();
  }
  return true;
}

Duration HeardOut::heard(Instant steady) {
  return starved_ ? time_of(heard_) : line_.at(steady);
}

std::optional<Duration> HeardOut::reported() const {
  if (heard_ == 0 || starved_) return std::nullopt;
  return time_of(report());
}

Duration HeardOut::lead() const {
  return std::min<Duration>(kLeadMin + static_cast<Duration::rep>(underruns_) * kLeadStep,
                            kLeadMax);
}

}  // namespace aucast::sound
