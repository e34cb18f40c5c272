#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aucast {

/// Largest AU number on the wire and in files; 0 is the neutral face.
inline constexpr int kAuNumberMax = 99;
inline constexpr int kAuCount = kAuNumberMax + 1;

/// The subject's own side. Both is for an AU that is written without a side: such an AU is set on
/// both sides, or only on the right one if it shows_on_one_side().
enum class Side : std::uint8_t { Both, Left, Right };

/// One AU as written in a packet: number 0-99, side, intensity in whole percent 0-100.
struct AuTerm {
  std::uint8_t number = 0;
  Side side = Side::Both;
  std::uint8_t percent = 100;
  friend bool operator==(const AuTerm&, const AuTerm&) = default;
};

/// One moment of a face: the intensity in [0,1] of every AU on each side; 0 means absent. Entry 0
/// (the neutral face) is always 0. A trivially copyable value of 800 bytes.
struct AuFrame {
  std::array<float, kAuCount> left{};
  std::array<float, kAuCount> right{};
  friend bool operator==(const AuFrame&, const AuFrame&) = default;
};

/// Whether the AU shows on only one side at a time. 30 (jaw sideways), 36 (tongue bulge) and 46
/// (wink) do.
[[nodiscard]] bool shows_on_one_side(int number);

/// Sets AU `number` (1-99) on a side; enum Side explains Both.
void set_intensity(AuFrame& frame, std::uint8_t number, Side side, float intensity);

/// The intensity, clamped to [0,1], as a whole percent, rounded.
[[nodiscard]] std::uint8_t percent_of(float intensity);

/// A name with its side: "left_brow", "right_brow", or "brow" for both.
[[nodiscard]] std::string sided_name(Side side, std::string_view base);

/// The parts from which sided_name() makes a name; `side` is Both for a name without a side. `base`
/// is a view into the name.
struct SidedName {
  Side side = Side::Both;
  std::string_view base;
};
[[nodiscard]] SidedName split_side(std::string_view name);

/// Left for Right, Right for Left, Both for Both.
[[nodiscard]] constexpr Side opposite(Side side) {
  return side == Side::Left ? Side::Right : side == Side::Right ? Side::Left : side;
}

/// Interpolates linearly: `share` 0 is `from`, 1 is `to`.
[[nodiscard]] AuFrame between(const AuFrame& from, const AuFrame& to, double share);

/// For each AU and side, the larger of the two intensities.
[[nodiscard]] AuFrame stronger(const AuFrame& a, const AuFrame& b);

/// The frame that the terms describe. If the same side of an AU comes twice, the last wins; AU 0
/// adds nothing; 0 percent means absent.
[[nodiscard]] AuFrame frame_from_terms(std::span<const AuTerm> terms);

/// Changes `frame` by terms of the changes-only form: AUs that no term names stay as they are.
void apply_terms(AuFrame& frame, std::span<const AuTerm> terms);

/// The canonical terms of a frame: ascending numbers, left before right, rounded to whole percent,
/// zeros dropped, equal sides joined into Side::Both (except for AUs that shows_on_one_side()); {0}
/// when nothing is left.
[[nodiscard]] std::vector<AuTerm> canonical_terms(const AuFrame& frame);

/// The FACS name of an AU or action descriptor, such as "Lip Corner Puller" for 12. It is the name
/// of FACS 2002, or of FACS 1978 where 2002 has none; nullopt if neither has one.
[[nodiscard]] std::optional<std::string_view> facs_name(int number);

/// The AU that has this name. Case, blanks and hyphens do not matter, and other usual names ("Lip
/// Pressor") are known too. nullopt for a text that is no AU's name, such as "smile".
[[nodiscard]] std::optional<std::uint8_t> facs_number(std::string_view name);

/// The percent that a FACS intensity letter stands for: A 10, B 25, C 50, D 80, E 100 (2002) and x
/// 25, y 60, z 100 (1978). nullopt for other letters; case matters.
[[nodiscard]] std::optional<std::uint8_t> percent_of_letter(char letter);

}  // namespace aucast
