#include "protocol/secret.h"

#include <cstddef>

#include "common/check.h"

namespace aucast::protocol {

bool same_secret(std::string_view shown, std::string_view kept) {
  AUCAST_CHECK(!kept.empty());
  // Volatile, so that the compiler does not leave the loop at the first difference.
  volatile unsigned difference = shown.size() == kept.size() ? 0U : 1U;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto ours = static_cast<unsigned char>(kept[i % kept.size()]);
    difference = difference | (static_cast<unsigned char>(shown[i]) ^ ours);
  }
  return difference == 0;
}

}  // namespace aucast::protocol
