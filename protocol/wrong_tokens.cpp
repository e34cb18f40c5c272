#include "protocol/wrong_tokens.h"

#include "protocol/limits.h"

namespace aucast::protocol {

bool WrongTokens::may_try(std::uint64_t address, Instant now) {
  while (!guesses_.empty() && guesses_.front().until <= now) forget_oldest();
  const auto found = of_address_.find(address);
  return found == of_address_.end() || found->second < kWrongTokensMax;
}

void WrongTokens::add(std::uint64_t address, Instant now) {
  if (guesses_.size() == kGuessesMax) forget_oldest();
  guesses_.push_back({now + kWrongTokensTime, address});
  ++of_address_[address];
  ++shown_;
}

void WrongTokens::forget_oldest() {
  const auto count = of_address_.find(guesses_.front().address);
  if (--count->second == 0) of_address_.erase(count);
  guesses_.pop_front();
}

}  // namespace aucast::protocol
