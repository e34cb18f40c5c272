#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "client/playback/keyframe_source.h"
#include "common/time.h"

namespace aucast::net {

/// Voice and captions that have come and wait to be taken: at most playback::kVoiceBytesMax bytes
/// and kVoicePacketsMax packets of voice, and kCaptionsMax captions. Whatever comes while there is
/// no room is left out and counted. Thread: none of its own.
class SpokenQueue {
 public:
  static constexpr std::size_t kCaptionsMax = 10'000;

  void add(playback::Voice voice);
  void add(playback::Caption caption);
  [[nodiscard]] std::optional<playback::Voice> take_voice();
  [[nodiscard]] std::optional<playback::Caption> take_caption();

  /// The place at which the last packet of voice that was kept ends.
  [[nodiscard]] Milliseconds voice_end() const { return voice_end_; }
  [[nodiscard]] std::uint64_t voice_left_out() const { return voice_left_out_; }
  [[nodiscard]] std::uint64_t captions_left_out() const { return captions_left_out_; }

 private:
  std::deque<playback::Voice> voice_;
  std::size_t voice_bytes_ = 0;
  Milliseconds voice_end_{0};
  std::deque<playback::Caption> captions_;
  std::uint64_t voice_left_out_ = 0;  ///< packets
  std::uint64_t captions_left_out_ = 0;
};

}  // namespace aucast::net
