#include "tests/support/seeded.h"

#include <cstdlib>

namespace aucast::test {
namespace {

std::uint64_t seed_from_environment() {
  const char* text = std::getenv("AUCAST_SEED");
  return text == nullptr ? 1 : std::strtoull(text, nullptr, 10);
}

}  // namespace

Seeded::Seeded() : Seeded(seed_from_environment()) {}

int Seeded::integer(int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(engine_);
}

double Seeded::real(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine_);
}

}  // namespace aucast::test
