#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>

#include "common/time.h"

namespace aucast::protocol {

/// Counts the wrong tokens of the last kWrongTokensTime, by the address from which they came. After
/// kWrongTokensMax from one address, no token from there is compared, not even the right one. Wrong
/// tokens of closed connections count too; otherwise guessing would be as fast as connecting.
/// Thread: none of its own.
class WrongTokens {
 public:
  /// Whether a token from this address may be compared now. `address`: any number that identifies
  /// it.
  [[nodiscard]] bool may_try(std::uint64_t address, Instant now);
  void add(std::uint64_t address, Instant now);
  /// How many tokens have been compared and found wrong so far.
  [[nodiscard]] std::uint64_t shown() const { return shown_; }

 private:
  struct Guess {
    Instant until;  ///< how long it counts
    std::uint64_t address;
  };

  void forget_oldest();

  std::deque<Guess> guesses_;  ///< the oldest first
  std::map<std::uint64_t, std::size_t> of_address_;
  std::uint64_t shown_ = 0;
};

/// The WrongTokens for the address of one client.
struct TokenCount {
  WrongTokens* wrong = nullptr;  ///< must outlive this; null: nothing is counted
  std::uint64_t address = 0;

  [[nodiscard]] bool may_try(Instant now) const {
    return wrong == nullptr || wrong->may_try(address, now);
  }
  void add_wrong(Instant now) const {
    if (wrong != nullptr) wrong->add(address, now);
  }
};

}  // namespace aucast::protocol
