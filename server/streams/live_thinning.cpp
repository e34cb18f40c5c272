#include "server/streams/live_thinning.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "server/streams/thinning.h"

namespace aucast::server {
namespace {

constexpr double kHeaderBits = kHeaderBytes * 8;
/// Packets with headers for each write: the peer answers it, and we acknowledge that answer.
constexpr double kSegmentsPerBatch = 2;

}  // namespace

LiveThinning::LiveThinning(std::uint32_t keyframe_ms, const LinkLimits& limits)
    : keyframe_ms_(keyframe_ms),
      limited_(limits.kbits > 0),
      changes_only_(limits.voice_kbits > 0),
      headers_(limits.batch.count() == 0 ? kHeaderBits : 0),
      voice_(limits.voice_kbits > 0
                 ? limits.voice_kbits * 1000.0 + headers_ / seconds(limits.voice_frame)
                 : 0),
      stretch_(Seconds(1) + limits.batch),
      most_(limits.kbits * 1000.0),
      encoder_(keyframe_ms, 0) {
  if (limits.batch.count() == 0) {
    // The voice's packets come whole: there may be one more than its rate says.
    most_ = std::max(most_ - voice_ * seconds(limits.voice_frame), 0.0);
    return;
  }
  most_ -= kSegmentsPerBatch * kHeaderBits * std::ceil(1 / seconds(limits.batch));
  most_ = std::max(most_, 0.0);
}

double LiveThinning::bits_of(const protocol::Keyframe& keyframe) const {
  protocol::KeyframeEncoder encoder = encoder_;
  const protocol::EncodedKeyframe encoded = encoder.next(keyframe);
  const std::string& packet = changes_only_ ? encoded.changes : encoded.full;
  return static_cast<double>(packet.size() * 8) + headers_;
}

void LiveThinning::push(protocol::Keyframe keyframe) {
  if (waiting_) {
    const std::uint64_t time_ms = std::uint64_t{waiting_->time_ms.value_or(keyframe_ms_)} +
                                  keyframe.time_ms.value_or(keyframe_ms_);
    give_time(keyframe, time_ms);
  }
  bits_ = limited_ ? bits_of(keyframe) : 0;
  waiting_ = std::move(keyframe);
}

void LiveThinning::spend(std::size_t bytes, SteadyTime now) {
  if (!limited_) return;
  spend_bits(static_cast<double>(bytes * 8) + headers_, now);
}

void LiveThinning::spend_bits(double bits, SteadyTime now) {
  last_ = std::max(last_, now);
  while (!spent_.empty() && spent_.front().at <= last_ - stretch_) spent_.pop_front();
  spent_.push_back({last_, bits});
}

std::optional<protocol::Keyframe> LiveThinning::pop(SteadyTime now) {
  if (!waiting_ || now < *due()) return std::nullopt;
  if (limited_) {
    spend_bits(bits_, now);
    static_cast<void>(encoder_.next(*waiting_));
  }
  return take_last();
}

std::optional<protocol::Keyframe> LiveThinning::take_last() {
  return std::exchange(waiting_, std::nullopt);
}

/// When the keyframe fits, together with the voice that will come until earlier bytes no longer
/// count.
std::optional<SteadyTime> LiveThinning::due() const {
  if (!waiting_) return std::nullopt;
  SteadyTime due;
  double there = most_ - bits_;
  for (auto spent = spent_.rbegin(); spent != spent_.rend() && limited_; ++spent) {
    there -= spent->bits;
    const SteadyTime past = spent->at + stretch_;
    if (there < 0) return std::max(due, past);
    if (voice_ > 0) due = std::max(due, past - Seconds(there / voice_));
  }
  return due;
}

}  // namespace aucast::server
