// Any text as a profile: an error with the file's name, or a profile whose numbers are in their
// ranges, that is written as it is read, and by which every face is one that can be shown.

#include <cmath>

#include "common/check.h"
#include "common/sources/profile.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::sources;

namespace {

void check_filter(const OneEuroSettings& filter) {
  AUCAST_CHECK(filter.min_cutoff_hz > 0 && filter.min_cutoff_hz <= kCutoffMax);
  AUCAST_CHECK(filter.beta >= 0 && filter.beta <= kBetaMax);
  AUCAST_CHECK(filter.derivative_cutoff_hz > 0 && filter.derivative_cutoff_hz <= kCutoffMax);
}

void check_ranges(const Profile& profile) {
  for (const bool right : {false, true}) {
    for (std::size_t number = 1; number < kAuCount; ++number) {
      const double gain = profile.gain.of(number, right);
      AUCAST_CHECK(gain >= 0 && gain <= kGainMax);
      const double percent = profile.dead_band.of(number, right);
      AUCAST_CHECK(percent >= 0 && percent <= kDeadBandMax && percent == std::floor(percent));
    }
  }
  if (profile.filter) check_filter(*profile.filter);
}

/// AUs of every strength, each side another, with gaps; turns and the distance beyond full.
AuFrame busy_face(int moment) {
  AuFrame face = no_data();
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const bool turn = opposite_of(number) != 0;
    if ((number + static_cast<std::size_t>(moment)) % 7 == 0) continue;
    face.left[number] = static_cast<float>(number) / (turn ? 10 : kAuNumberMax);
    face.right[number] = moment % 2 == 0 ? 1.0F : 0.0F;
  }
  return face;
}

void check_shown(const Profile& profile) {
  ConditioningSettings settings;
  settings.profile = profile;
  settings.distance = true;
  Conditioning conditioning(settings);
  for (int moment = 0; moment < 8; ++moment) {
    const AuFrame shown = conditioning.apply(0.25 * moment, busy_face(moment));
    for (const auto& side : {shown.left, shown.right}) {
      for (const float value : side) AUCAST_CHECK(value == -1 || (value >= 0 && value <= 1));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto profile = parse_profile(fuzz::text_of(data, size), "f");
  if (!profile) {
    AUCAST_CHECK(profile.error().kind == ErrorKind::BadData);
    AUCAST_CHECK(profile.error().message.starts_with("f:"));
    return 0;
  }
  check_ranges(*profile);
  check_shown(*profile);
  const std::string text = format_profile(*profile);
  const auto again = parse_profile(text, "f");
  AUCAST_CHECK(again.has_value());
  AUCAST_CHECK(again->gain == profile->gain && again->dead_band == profile->dead_band);
  AUCAST_CHECK(again->filter == profile->filter);
  AUCAST_CHECK(format_profile(*again) == text);
  return 0;
}
