#include "protocol/wrong_tokens.h"

#include "protocol/limits.h"

namespace aucast::protocol {

bool WrongTokens::may_try(std::uint64_t address, Instant now) {
  for (; !guesses_.empty() && guesses_.front().until <= now; guesses_.pop_front()) {
    const auto count = of_address_.find(guesses_.front().address);
    if (--count->second == 0) of_address_.erase(count);
  }
  const auto found = of_address_.find(address);
  return found == of_address_.end() || found->second < kWrongTokensMax;
}

void WrongTokens::add(std::uint64_t address, Instant now) {
  guesses_.push_back({now + kWrongTokensTime, address});
  ++of_address_[address];
}

}  // namespace aucast::protocol
