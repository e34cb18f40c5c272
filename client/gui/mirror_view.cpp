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

/// The pair that the number is of; null: it stands alone.
const Pair* pair_of(int number) {
  const auto* const pair = std::find_if(kPairs.begin(), kPairs.end(), [number](const Pair& one) {
    return number == one.first || number == one.first + 1;
  });
  return pair == kPairs.end() ? nullptr : pair;
}

std::string label_of(int number, const Pair* pair) {
  if (pair != nullptr) return pair->label;
  return std::to_string(number) + " " + std::string(facs_name(number).value_or(""));
}

}  // namespace

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
