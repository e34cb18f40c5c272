#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "common/time.h"
#include "protocol/codec.h"
#include "protocol/packet.h"

namespace aucast::server {

/// What a live stream may take of a link, and how the stream is written to it.
struct LinkLimits {
  std::uint32_t kbits = 0;  ///< kilobits a second, headers included; 0: no limit
  Milliseconds batch{0};    ///< how long small writes wait for more
  /// Kilobits a second of the voice, without headers; 0: there is none. With a voice, the size of a
  /// keyframe is that of its changes-only form, otherwise that of its full form.
  std::uint32_t voice_kbits = 0;
  Milliseconds voice_frame{60};  ///< length of each voice packet
};

/// Fits keyframes and voice, as they come, into LinkLimits::kbits. A keyframe that comes too soon
/// waits until there is room for it; a newer one replaces it and lasts as long as both. The voice
/// is never delayed, and the face gets the rest. All headers are counted. No second has more than
/// the limit, unless the voice alone takes more or one keyframe is larger. Some room is left for
/// what --batch may move from one second into the next.
class LiveThinning {
 public:
  /// `keyframe_ms`: of an untimed keyframe.
  LiveThinning(std::uint32_t keyframe_ms, const LinkLimits& limits);

  /// Adds a full keyframe, which waits until pop() returns it.
  void push(protocol::Keyframe keyframe);
  /// Counts `bytes` of voice that are sent.
  void spend(std::size_t bytes, SteadyTime now);
  /// The keyframe that waits, when its time has come; nullopt otherwise.
  [[nodiscard]] std::optional<protocol::Keyframe> pop(SteadyTime now);
  /// Takes out the keyframe that waits, whether or not its time has come; nullopt: none waits.
  [[nodiscard]] std::optional<protocol::Keyframe> take_last();
  /// When pop() will return a keyframe, as far as is known; nullopt while none waits.
  [[nodiscard]] std::optional<SteadyTime> due() const;

 private:
  struct Spent {
    SteadyTime at;
    double bits = 0;
  };

  [[nodiscard]] double bits_of(const protocol::Keyframe& keyframe) const;
  void spend_bits(double bits, SteadyTime now);

  std::uint32_t keyframe_ms_;
  bool limited_;
  bool changes_only_;
  double headers_;           ///< bits, for each packet that is written alone
  double voice_;             ///< bits a second that are reserved for the voice
  Seconds stretch_;          ///< in which bits are counted
  double most_;              ///< bits in a stretch, without the headers of batches
  std::deque<Spent> spent_;  ///< in the last stretch_
  double bits_ = 0;          ///< size of the keyframe that waits
  SteadyTime last_;          ///< when something was last sent
  protocol::KeyframeEncoder encoder_;
  std::optional<protocol::Keyframe> waiting_;
};

}  // namespace aucast::server
