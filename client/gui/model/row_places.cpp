#include "client/gui/model/row_places.h"

#include <algorithm>
#include <map>
#include <utility>

namespace aucast::gui {
namespace {

/// By ID, without those that are there more than once.
std::map<unsigned, float> places_of(const std::vector<RowPlace>& rows) {
  std::map<unsigned, std::pair<float, int>> all;
  for (const RowPlace& row : rows) {
    auto& [y, count] = all[row.id];
    y = row.y;
    ++count;
  }
  std::map<unsigned, float> single;
  for (const auto& [id, place] : all) {
    if (place.second == 1) single[id] = place.first;
  }
  return single;
}

}  // namespace

float moved_down(const std::vector<RowPlace>& before, const std::vector<RowPlace>& now, float at) {
  const std::map<unsigned, float> after = places_of(now);
  float nearest = -1;
  float moved = 0;
  for (const auto& [id, y] : places_of(before)) {
    const auto found = after.find(id);
    if (found == after.end() || y > at || y <= nearest) continue;
    nearest = y;
    moved = found->second - y;
  }
  return moved;
}

}  // namespace aucast::gui
