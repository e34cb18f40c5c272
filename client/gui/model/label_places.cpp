#include "client/gui/model/label_places.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace aucast::gui {

std::vector<float> label_places(const std::vector<float>& wanted, float gap, float top,
                                float bottom) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  if (wanted.size() > 1) {
    gap = std::min(gap, (bottom - top) / static_cast<float>(wanted.size() - 1));
  }
  std::vector<float> places(wanted.size());
  float least = top;
  for (const std::size_t one : order) {
    places[one] = std::max(std::min(wanted[one], bottom), least);
    least = places[one] + gap;
  }
  // What was pushed out at the bottom pushes the others up.
  float most = bottom;
  for (auto one = order.rbegin(); one != order.rend(); ++one) {
    places[*one] = std::min(places[*one], most);
    most = places[*one] - gap;
  }
  return places;
}

}  // namespace aucast::gui
