#include "server/live/source_silence.h"

#include <algorithm>

#include "common/earlier.h"
#include "common/sources/hold.h"

namespace aucast::server {
namespace {

constexpr Seconds kHold(sources::kHoldSeconds);

}  // namespace

bool SourceSilence::to_be_said(SteadyTime since, SteadyTime now) {
  return now - since >= kHold && !std::exchange(said_, true);
}

Seconds SourceSilence::patience() const {
  const Seconds asked = time_out_;
  return final_ ? std::min(asked, kHold + Seconds(sources::kEaseSeconds)) : asked;
}

std::optional<SteadyTime> SourceSilence::next(SteadyTime since, bool ended) const {
  std::optional<SteadyTime> next;
  if (!said_) next = since + kHold;
  if (!ends() || ended) return next;
  return earlier(next, std::optional(since + patience()));
}

}  // namespace aucast::server
