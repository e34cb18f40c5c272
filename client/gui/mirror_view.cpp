#include "client/gui/mirror_view.h"

#include <algorithm>
#include <array>

namespace aucast::gui {
namespace {

/// AUs of which a face has one at a time: the first goes to the left or up, the next to the right
/// or down.
struct Pair {
  int first;
  const char* label;
};
constexpr std::array<Pair, 5> kPairs = {{{51, "51 52 Head Left, Right"},
                                         {53, "53 54 Head Up, Down"},
                                         {55, "55 56 Head Tilt"},
                                         {61, "61 62 Eyes Left, Right"},
                                         {63, "63 64 Eyes Up, Down"}}};

/// The bar that the number belongs to, made when it is the first of it.
AuBar& bar_of(int number, int& last, std::vector<AuBar>& bars) {
  const auto pair = std::find_if(kPairs.begin(), kPairs.end(), [number](const Pair& one) {
    return number == one.first || number == one.first + 1;
  });
  const int first = pair == kPairs.end() ? number : pair->first;
  if (first != last || bars.empty()) {
    const std::string name = std::string(facs_name(number).value_or(""));
    bars.push_back({pair == kPairs.end() ? std::to_string(number) + " " + name : pair->label});
    last = first;
  }
  return bars.back();
}

bool is_second(int number) {
  return std::any_of(kPairs.begin(), kPairs.end(),
                     [number](const Pair& one) { return number == one.first + 1; });
}

bool is_first(int number) {
  return std::any_of(kPairs.begin(), kPairs.end(),
                     [number](const Pair& one) { return number == one.first; });
}

}  // namespace

std::vector<AuBar> au_bars(const std::vector<AuTerm>& aus) {
  std::vector<AuTerm> ordered = aus;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const AuTerm& a, const AuTerm& b) { return a.number < b.number; });
  std::vector<AuBar> bars;
  int last = 0;
  for (const AuTerm& term : ordered) {
    AuBar& bar = bar_of(term.number, last, bars);
    const bool left = term.side != Side::Right && !is_second(term.number);
    const bool right = term.side != Side::Left && !is_first(term.number);
    if (left) bar.left_percent = term.percent;
    if (right) bar.right_percent = term.percent;
  }
  return bars;
}

std::string audience_text(const MirrorView& view) {
  using Phase = MirrorView::Phase;
  switch (view.phase) {
    case Phase::Off:
      return "The camera is off.";
    case Phase::Starting:
      return "The camera is being opened ...";
    case Phase::Ending:
      return "The camera is being closed ...";
    case Phase::Private:
      return "Only you see this face.";
    case Phase::Live:
      break;
  }
  const std::string who = view.watching == 0   ? "nobody watches yet"
                          : view.watching == 1 ? "1 watches"
                                               : std::to_string(view.watching) + " watch";
  return "Live at " + view.live + ", " + who + ".";
}

}  // namespace aucast::gui
