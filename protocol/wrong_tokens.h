#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>

#include "common/time.h"

namespace aucast::protocol {

/// The wrong tokens of the last kWrongTokensTime, by the address that they came from: after
/// kWrongTokensMax of them no token from there is compared, not even the right one. Connections
/// that were closed since count too, or guessing would be as fast as connecting.
/// Thread: none of its own.
class WrongTokens {
 public:
  /// How many wrong tokens of all addresses are kept. When more come the oldest are forgotten:
  /// their addresses may guess again a little sooner, but nobody's right token is refused for lack
  /// of room.
  static constexpr std::size_t kGuessesMax = 65'536;

  /// `address`: any number that stands for it.
  [[nodiscard]] bool may_try(std::uint64_t address, Instant now);
  void add(std::uint64_t address, Instant now);

 private:
  struct Guess {
    Instant until;  ///< it counts
    std::uint64_t address;
  };

  void forget_oldest();

  std::deque<Guess> guesses_;  ///< the oldest first
  std::map<std::uint64_t, std::size_t> of_address_;
};

/// The same for the address of one client.
struct TokenCount {
  WrongTokens* wrong = nullptr;  ///< outlives this; nullptr: nothing is counted
  std::uint64_t address = 0;

  [[nodiscard]] bool may_try(Instant now) const {
    return wrong == nullptr || wrong->may_try(address, now);
  }
  void add_wrong(Instant now) const {
    if (wrong != nullptr) wrong->add(address, now);
  }
};

}  // namespace aucast::protocol
