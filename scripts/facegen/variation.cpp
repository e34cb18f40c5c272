#include "scripts/facegen/variation.h"

#include <array>
#include <random>

namespace aucast::facegen {
namespace {

/// How far at most, of the way between two people.
constexpr double kWayMax = 0.4;
constexpr double kSkinDarkest = 0.55;
constexpr double kSkinLightest = 1.1;

constexpr std::array kMeasures{
    &Form::narrowing,      &Form::jaw_width,    &Form::jaw_bow,      &Form::jaw_drop,
    &Form::chin_width,     &Form::chin_drop,    &Form::chin_forward, &Form::cheek,
    &Form::cheekbone,      &Form::cheek_hollow, &Form::brow_ridge,   &Form::muzzle,
    &Form::nose_width,     &Form::bridge_width, &Form::nose_forward, &Form::nose_up,
    &Form::nose_tip,       &Form::nose_hump,    &Form::nose_root,    &Form::upper_lid,
    &Form::lower_lid,      &Form::lid_fold,     &Form::eye_bag,      &Form::socket,
    &Form::upper_lip,      &Form::lower_lip,    &Form::lip_bulge,    &Form::cupids_bow,
    &Form::corner_lift,    &Form::philtrum,     &Form::brow_up,      &Form::brow_arch,
    &Form::brow_tail_drop, &Form::brow_begin,   &Form::brow_width,   &Form::furrow,
    &Form::chin_fold};
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
  for (const auto measure : kMeasures) {
    const double way = kWayMax * (2 * part() - 1);
    person.form.*measure += way * (other.form.*measure - who.form.*measure);
  }
  const double light = kSkinDarkest + (kSkinLightest - kSkinDarkest) * part();
  for (const auto colour : kSkin) person.colours.*colour = person.colours.*colour * light;
  return person;
}

}  // namespace aucast::facegen
