#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "common/time.h"
#include "tests/support/seeded.h"

namespace aucast::test {

/// One direction of a connection in memory, as TCP over a bad link: bytes come late and in
/// other portions than they were written in, but in order.
class FaultyLink {
 public:
  FaultyLink(Seeded& seeded, Milliseconds delay_max) : seeded_(seeded), delay_max_(delay_max) {}

  void write(std::string_view bytes, Instant now);
  /// Nothing more will be written.
  void end() { ended_ = true; }
  /// What has come by now, or the first part of it; empty: nothing yet.
  [[nodiscard]] std::string read(Instant now);
  /// Whether all has been read and nothing more will come.
  [[nodiscard]] bool at_end() const { return ended_ && pieces_.empty(); }
  /// Nothing gets through before `until`.
  void go_down(Instant until) { down_until_ = until; }
  /// What is on its way is lost.
  void cut() { pieces_.clear(); }

 private:
  struct Piece {
    Instant due;
    std::string bytes;
  };

  Seeded& seeded_;
  Milliseconds delay_max_;
  Instant down_until_{};
  std::deque<Piece> pieces_;
  bool ended_ = false;
};

}  // namespace aucast::test
