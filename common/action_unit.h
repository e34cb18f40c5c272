#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace aucast {

/// Largest AU number on the wire and in files; 0 is the neutral face.
inline constexpr int kAuNumberMax = 99;
inline constexpr int kAuCount = kAuNumberMax + 1;

/// The subject's own side. Both is an AU scored without a side.
enum class Side : std::uint8_t { Both, Left, Right };

/// One AU as written in a packet: number 0-99, side, intensity in whole percent 0-100.
struct AuTerm {
  std::uint8_t number = 0;
  Side side = Side::Both;
  std::uint8_t percent = 100;
  friend bool operator==(const AuTerm&, const AuTerm&) = default;
};

/// One moment of a face: the intensity in [0,1] of every AU on each side; 0 is absent. Entry 0
/// (the neutral face) is always 0. A trivially copyable value of 800 bytes.
struct AuFrame {
  std::array<float, kAuCount> left{};
  std::array<float, kAuCount> right{};
  friend bool operator==(const AuFrame&, const AuFrame&) = default;
};

/// The frame that the terms describe. A repeated AU and side: the last wins; AU 0 adds nothing; 0
/// percent is absent.
[[nodiscard]] AuFrame frame_from_terms(std::span<const AuTerm> terms);

/// Changes `frame` by terms of the changes-only form: what is not named stays.
void apply_terms(AuFrame& frame, std::span<const AuTerm> terms);

/// The canonical form: ascending numbers, equal sides joined, left before right, rounded to whole
/// percent with zeros dropped; {0} when nothing is left.
[[nodiscard]] std::vector<AuTerm> canonical_terms(const AuFrame& frame);

/// The FACS (2002) name of an AU, such as "Lip Corner Puller" for 12; nothing for numbers without
/// one.
[[nodiscard]] std::optional<std::string_view> facs_name(int number);

/// The percent that a FACS intensity letter stands for: A 10, B 25, C 50, D 80, E 100 (2002) and
/// x 25, y 60, z 100 (1978). Nothing for other letters; case matters.
[[nodiscard]] std::optional<std::uint8_t> percent_of_letter(char letter);

}  // namespace aucast
