#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "common/time.h"
#include "protocol/codec.h"
#include "protocol/packet.h"

namespace aucast::server {

/// What a live stream may take on a link, and how it is written.
struct LinkLimits {
  std::uint32_t kbits = 0;  ///< a second, headers included; 0: any
  Milliseconds batch{0};    ///< how long small writes wait for each other
  /// What the voice is promised to take, headers left out; 0: there is none. With one, keyframes
  /// count in their changes-only form, else in their full one.
  std::uint32_t voice_kbits = 0;
  Milliseconds voice_frame{60};  ///< of each of its packets
};

/// Fits keyframes and voice that come one by one, without looking ahead, into so many kilobits a
/// second: a keyframe that comes too soon waits until there is room for it, and a newer one
/// replaces it and takes over its time. The voice is never held up, and the face gets what it
/// leaves. All headers are counted. No second has more than the limit, unless the voice alone takes
/// more or one keyframe is larger; room is left for what --batch may move from one second into the
/// next. Times are seconds of one clock.
class LiveThinning {
 public:
  /// `keyframe_ms`: of an untimed keyframe.
  LiveThinning(std::uint32_t keyframe_ms, const LinkLimits& limits);

  /// A full keyframe.
  void push(protocol::Keyframe keyframe);
  /// Of the voice, `bytes` are sent.
  void spend(std::size_t bytes, SteadySeconds now);
  /// The one that waits, when its time has come.
  [[nodiscard]] std::optional<protocol::Keyframe> pop(SteadySeconds now);
  /// The one that waits, without looking at the time: nothing comes after it.
  [[nodiscard]] std::optional<protocol::Keyframe> take_last();
  /// When pop() has something, as far as is known; nothing while none waits.
  [[nodiscard]] std::optional<double> due() const;

 private:
  struct Spent {
    double at = 0;
    double bits = 0;
  };

  [[nodiscard]] double bits_of(const protocol::Keyframe& keyframe) const;
  void spend_bits(double bits, SteadySeconds now);

  std::uint32_t keyframe_ms_;
  bool limited_;
  bool changes_only_;
  double headers_;           ///< bits, of each that is written alone
  double voice_;             ///< bits a second that are kept for it
  double stretch_;           ///< seconds
  double most_;              ///< bits in a stretch, without the headers of batches
  std::deque<Spent> spent_;  ///< in the latest stretch
  double bits_ = 0;          ///< of the one that waits
  double last_ = 0;          ///< seconds: when anything was sent last
  protocol::KeyframeEncoder encoder_;
  std::optional<protocol::Keyframe> waiting_;
};

}  // namespace aucast::server
