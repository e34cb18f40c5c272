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

/// The lips' shape for a class of speech sounds.
struct Viseme {
  std::string_view name;
  std::array<LipAu, 3> aus{};  ///< number 0: not used
  float dominance = 0;         ///< how much it prevails over its neighbours, in [0,1]
  int lead_ms = 0;             ///< how long before the sound the lips begin to move
  bool closes = false;         ///< the lips must meet: p, b, m
  bool on_teeth = false;       ///< the lower lip must touch the upper teeth: f, v
};

/// The lips at rest, in a pause.
[[nodiscard]] const Viseme& pause_viseme();

/// The viseme of a sound, by its first IPA letter; null for a sound in which the lips take no part.
[[nodiscard]] const Viseme* viseme_of(std::string_view ipa);

/// The viseme with which a diphthong ends, that of its last vowel; null for other sounds.
[[nodiscard]] const Viseme* glide_of(std::string_view ipa);

/// How long before espeak-ng's mark, which is at the burst, the lips close for a p or b; 0 for
/// other sounds.
[[nodiscard]] int closure_before_ms(std::string_view ipa);

}  // namespace aucast::speaker
