#pragma once

#include <cstddef>

namespace aucast::protocol {

/// Whether one client may be sent a keyframe now: the window of section 6 of PROTOCOL.md, the
/// client's pauses, and whether its connection takes more. Thread: none of its own.
class AnswerWindow {
 public:
  /// How many keyframes may be in flight; 0: keyframes are not answered.
  void set_size(std::size_t size) { size_ = size; }

  /// Counts a keyframe that is sent. Returns whether a banked answer has answered it already.
  bool count_sent() {
    if (size_ == 0) return false;
    if (banked_ == 0) {
      ++in_flight_;
      return false;
    }
    --banked_;
    return true;
  }
  /// Counts an answer to the oldest keyframe in flight. Returns false if none is; then the answer
  /// is banked for the next one that is sent.
  bool count_answer() {
    if (in_flight_ == 0) {
      ++banked_;
      return false;
    }
    --in_flight_;
    return true;
  }
  void set_paused(bool paused) { paused_ = paused; }
  /// With true, the connection takes no more until a call with false.
  void set_blocked(bool blocked) { blocked_ = blocked; }

  [[nodiscard]] bool may_send() const {
    return !paused_ && !blocked_ && (size_ == 0 || in_flight_ < size_);
  }
  /// Whether everything sent was answered, and nothing keeps {-2} back.
  [[nodiscard]] bool settled() const { return !paused_ && !blocked_ && in_flight_ == 0; }
  /// Whether keyframes are answered.
  [[nodiscard]] bool answers() const { return size_ > 0; }
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] bool blocked() const { return blocked_; }
  /// Keyframes that were sent and not answered.
  [[nodiscard]] std::size_t in_flight() const { return in_flight_; }
  /// Answers that came while nothing was in flight. Some are banked only while nothing is.
  [[nodiscard]] std::size_t banked() const { return banked_; }

 private:
  std::size_t size_ = 1;
  std::size_t in_flight_ = 0;
  std::size_t banked_ = 0;
  bool paused_ = false;
  bool blocked_ = false;
};

}  // namespace aucast::protocol
