#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::web {

/// The keyframes that playback has begun: first those that are not heard and seen yet, for playback
/// is ahead of the sound, then their lines until the page takes them. Of both the newest kMax are
/// kept, since a page that does not listen to keyframes never takes a line.
/// Thread: the page's.
class BegunKeyframes {
 public:
  static constexpr std::size_t kMax = 1'000;

  struct Begun {
    Instant at;
    AuFrame aus;
    std::string line;
  };
  /// `at` ascends.
  void add(Begun keyframe);
  /// Returns the AUs of the last keyframe up to `heard` that was not passed before; nullopt: there
  /// is none.
  std::optional<AuFrame> pass(Instant heard);
  /// The lines of the keyframes that were passed since the last call.
  [[nodiscard]] std::vector<std::string> take_lines();
  /// Forgets what was not passed.
  void clear() { ahead_.clear(); }

 private:
  std::deque<Begun> ahead_;
  std::deque<std::string> lines_;
};

}  // namespace aucast::web
