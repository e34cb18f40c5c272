#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace aucast::speaker {

/// An AU of the mouth and how strong it is, in [0,1].
struct LipAu {
  std::uint8_t number = 0;
  float intensity = 0;
};

/// What the lips do for a class of speech sounds.
struct Viseme {
  std::string_view name;
  std::array<LipAu, 3> aus{};  ///< number 0: not used
  float dominance = 0;         ///< how much of the neighbours' lips it takes over, in [0,1]
  int lead_ms = 0;             ///< how long before the sound the lips begin
  bool closes = false;         ///< the lips must meet: p, b, m
  bool on_teeth = false;       ///< the lower lip must touch the upper teeth: f, v
};

/// The rest of the lips in a pause.
[[nodiscard]] const Viseme& pause_viseme();

/// What a sound looks like, by its first IPA letter; null for one that the lips take no part in.
[[nodiscard]] const Viseme* viseme_of(std::string_view ipa);

/// A diphthong ends elsewhere: what its last vowel looks like. Null for other sounds.
[[nodiscard]] const Viseme* glide_of(std::string_view ipa);

/// How long before espeak-ng's mark of a stop its closure begins: the mark is the burst.
[[nodiscard]] int closure_before_ms(std::string_view ipa);

}  // namespace aucast::speaker
