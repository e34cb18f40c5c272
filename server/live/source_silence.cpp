#include "server/live/source_silence.h"

#include <algorithm>

#include "common/earlier.h"
#include "common/sources/hold.h"

namespace aucast::server {

bool SourceSilence::to_be_said(double since, double now) {
  return now - since >= sources::kHoldSeconds && !std::exchange(said_, true);
}

double SourceSilence::patience() const {
  const double asked = seconds(time_out_);
  return final_ ? std::min(asked, sources::kHoldSeconds + sources::kEaseSeconds) : asked;
}

std::optional<double> SourceSilence::next(double since, bool ended) const {
  std::optional<double> next;
  if (!said_) next = since + sources::kHoldSeconds;
  if (!ends() || ended) return next;
  return earlier(next, std::optional(since + patience()));
}

}  // namespace aucast::server
