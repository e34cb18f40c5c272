#include "client/app/window/pace_meter.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "client/gui/texts/texts.h"

namespace aucast::app {
namespace {

std::string decimal(double value, int digits, const char* unit) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*f%s", digits, value, unit);
  return text.data();
}

std::string mean_ms(Duration sum) {
  return decimal(seconds(sum) * 1000 / PaceMeter::kFrames, 1, " ms");
}

}  // namespace

std::optional<std::vector<gui::PaceRow>> PaceMeter::add(const FrameTimes& times, Instant now) {
  sum_.mix += times.mix;
  sum_.deform += times.deform;
  sum_.face += times.face;
  sum_.panels += times.panels;
  if (++frames_ < kFrames) return std::nullopt;
  const double elapsed = seconds(now - std::exchange(begin_, now));
  const FrameTimes sum = std::exchange(sum_, {});
  frames_ = 0;
  return std::vector<gui::PaceRow>{{gui::tr("said.pace_rate"), decimal(kFrames / elapsed, 0, "")},
                                   {gui::tr("said.pace_mix"), mean_ms(sum.mix)},
                                   {gui::tr("said.pace_deform"), mean_ms(sum.deform)},
                                   {gui::tr("said.pace_face"), mean_ms(sum.face)},
                                   {gui::tr("said.pace_panels"), mean_ms(sum.panels)}};
}

}  // namespace aucast::app
