#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/action_unit.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// An AU as it is written in a packet: 12, L12, R12.
struct AuName {
  std::uint8_t number = 0;  ///< 1-99
  Side side = Side::Both;
  friend bool operator==(const AuName&, const AuName&) = default;
};

[[nodiscard]] std::optional<AuName> parse_au_name(std::string_view text);

/// A number for every AU on each side.
class PerAu {
 public:
  explicit PerAu(double all) { set_all(all); }

  [[nodiscard]] double of(std::size_t number, bool right) const {
    return values_[channel_of(number, right)];
  }
  /// The number that set_all() set last.
  [[nodiscard]] double all() const { return all_; }
  /// Sets the number of every AU.
  void set_all(double value);
  void set(const AuName& au, double value);
  /// The AUs whose number differs from all(), ascending. Where both sides are equal, there is one
  /// entry, with Side::Both.
  [[nodiscard]] std::vector<std::pair<AuName, double>> exceptions() const;

  friend bool operator==(const PerAu&, const PerAu&) = default;

 private:
  double all_ = 0;
  std::array<double, kChannels> values_{};
};

/// "12", "L12".
[[nodiscard]] std::string au_name_text(const AuName& au);

}  // namespace aucast::sources
