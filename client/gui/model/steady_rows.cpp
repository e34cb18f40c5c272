#include "client/gui/model/steady_rows.h"

#include <algorithm>
#include <string_view>

namespace aucast::gui {
namespace {

/// "12" is before "L12", "R12" and "14".
bool is_before(const AuRow& one, const AuRow& other) {
  const auto number = [](std::string_view label) {
    label.remove_prefix(std::min(label.find_first_of("0123456789"), label.size()));
    return label;
  };
  const std::string_view a = number(one.label);
  const std::string_view b = number(other.label);
  if (a.size() != b.size()) return a.size() < b.size();
  return a != b ? a < b : one.label < other.label;
}

}  // namespace

const std::vector<AuRow>& SteadyRows::with(const std::vector<AuRow>& rows,
                                           const std::string& stream) {
  if (stream != stream_) kept_.clear();
  stream_ = stream;
  for (AuRow& row : kept_) {
    row.received_percent = row.shown_percent = 0;
    row.why.clear();
  }
  for (const AuRow& row : rows) {
    auto place = std::lower_bound(kept_.begin(), kept_.end(), row, is_before);
    if (place == kept_.end() || place->label != row.label) place = kept_.insert(place, row);
    const bool room = place->room_for_why || !row.why.empty();
    *place = row;
    place->room_for_why = room;
  }
  return kept_;
}

}  // namespace aucast::gui
