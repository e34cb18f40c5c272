#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace aucast::test {

/// A random generator. Its seed is $AUCAST_SEED if set, else 1; SCOPED_TRACE(seeded.trace()) prints
/// the seed when the test fails.
class Seeded {
 public:
  Seeded();
  explicit Seeded(std::uint64_t seed) : seed_(seed), engine_(seed) {}

  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] std::string trace() const { return "AUCAST_SEED=" + std::to_string(seed_); }
  /// Uniform in [low, high].
  [[nodiscard]] int integer(int low, int high);
  /// Uniform in [low, high).
  [[nodiscard]] double real(double low, double high);
  [[nodiscard]] bool chance(double probability) { return real(0, 1) < probability; }

 private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

}  // namespace aucast::test
