#include "client/app/loss_warnings.h"

namespace aucast::app {

std::string LossWarnings::look_at(const playback::Playback& playback) {
  const playback::SourceStatus status = playback.status();
  const bool goes_on = status.end == playback::EndReason::NotEnded;
  if (!goes_on || status.connected || status.reason.empty()) return {};
  const std::uint64_t played = playback.keyframes_played();
  // The next loss may read like the last, but something was played between them.
  if (status.detail == said_ && played == played_) return {};
  said_ = status.detail;
  played_ = played;
  return said_;
}

}  // namespace aucast::app
