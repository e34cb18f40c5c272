#include "scripts/facegen/variation.h"

#include <array>
#include <random>

namespace aucast::facegen {
namespace {

/// How far at most, of the way between two people.
constexpr double kWayMax = 0.4;
constexpr double kSkinDarkest = 0.55;
constexpr double kSkinLightest = 1.1;

constexpr std::array kSkin{&Palette::skin,      &Palette::flush,    &Palette::forehead_skin,
                           &Palette::neck_skin, &Palette::lid_skin, &Palette::lid_rim,
                           &Palette::lip};

}  // namespace

Identity varied(const Identity& who, const Identity& other, std::uint32_t number) {
  Identity person = who;
  if (number == 0) return person;
  std::mt19937 bits(number);
  // Not a distribution of the library's: those differ from one to the next.
  const auto part = [&bits] { return static_cast<double>(bits()) / 4294967295.0; };
  for (const Measure& measure : form_measures()) {
    if (!measure.varies) continue;
    const double way = kWayMax * (2 * part() - 1);
    const auto member = measure.member;
    person.form.*member += way * (other.form.*member - who.form.*member);
  }
  const double light = kSkinDarkest + (kSkinLightest - kSkinDarkest) * part();
  for (const auto colour : kSkin) person.colours.*colour = person.colours.*colour * light;
  return person;
}

}  // namespace aucast::facegen
