#include "common/random_digits.h"

#include <random>
#include <string_view>

namespace aucast {

std::string random_digits(std::size_t count) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::random_device random;
  std::string digits;
  while (digits.size() < count) digits += kDigits[random() % kDigits.size()];
  return digits;
}

}  // namespace aucast
