#include "client/gui/model/mirror_view.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "client/gui/texts/texts.h"
#include "common/film_name.h"

namespace aucast::gui {
namespace {

/// Pairs of AUs of which a face can have only one at a time: the first goes left or up, the second
/// right or down.
struct Pair {
  int first;
  TextKey label;
};
constexpr std::array<Pair, 5> kPairs = {{{51, "camera.turn"},
                                         {53, "camera.nod"},
                                         {55, "camera.tilt"},
                                         {61, "camera.eyes_turn"},
                                         {63, "camera.eyes_nod"}}};

/// The pair to which the number belongs; null: none.
const Pair* pair_of(int number) {
  const auto* const pair = std::find_if(kPairs.begin(), kPairs.end(), [number](const Pair& one) {
    return number == one.first || number == one.first + 1;
  });
  return pair == kPairs.end() ? nullptr : pair;
}

std::string label_of(int number, const Pair* pair) {
  if (pair != nullptr) return tr(pair->label);
  return std::to_string(number) + " " + au_name(number);
}

}  // namespace

std::string device_of(const std::string& source) {
  constexpr std::string_view kCamera = "camera:";
  return source.starts_with(kCamera) ? source.substr(kCamera.size()) : source;
}

bool is_film_source(const std::string& source) {
  return is_film(device_of(source));
}

std::vector<AuBar> au_bars(const std::vector<AuTerm>& aus) {
  std::vector<AuTerm> ordered = aus;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const AuTerm& a, const AuTerm& b) { return a.number < b.number; });
  std::vector<AuBar> bars;
  int last = 0;
  for (const AuTerm& term : ordered) {
    const Pair* const pair = pair_of(term.number);
    const int first = pair == nullptr ? term.number : pair->first;
    if (first != last || bars.empty()) bars.push_back({label_of(term.number, pair)});
    last = first;
    const bool left = pair == nullptr ? term.side != Side::Right : term.number == first;
    const bool right = pair == nullptr ? term.side != Side::Left : term.number != first;
    if (left) bars.back().left_percent = term.percent;
    if (right) bars.back().right_percent = term.percent;
  }
  return bars;
}

std::string viewers_text(const MirrorView& view) {
  using Phase = MirrorView::Phase;
  switch (view.phase) {
    case Phase::Off:
      return tr("camera.is_off");
    case Phase::Starting:
      return tr("camera.is_starting");
    case Phase::Ending:
      return tr("camera.is_ending");
    case Phase::Private:
      return tr("camera.is_private");
    case Phase::Live:
      break;
  }
  if (view.watching == 0) return tr("camera.live_nobody", view.live);
  if (view.watching == 1) return tr("camera.live_one", view.live);
  return tr("camera.live_many", view.live, view.watching);
}

std::string admission_text(const MirrorView& view) {
  const char* needed = view.asks_token ? tr("camera.needs_token") : tr("camera.needs_address");
  return view.asks_tls ? std::string(needed) + " " + tr("camera.needs_tls") : needed;
}

}  // namespace aucast::gui
