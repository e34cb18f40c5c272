#pragma once

#include <string_view>
#include <vector>

#include "client/gui/model/row_places.h"

namespace aucast::gui {

/// Keeps what the pointer is on in its place while rows above it come and go: a panel that has been
/// scrolled is scrolled by as much as they take. Where the pointer is elsewhere, what is at the
/// panel's upper edge keeps its place.
class KeptPlace {
 public:
  /// Call it in the window that scrolls, before its first row.
  void begin();
  /// Call it after the last row. Returns whether rows have moved; the next frame has them in place
  /// again.
  [[nodiscard]] bool end();

 private:
  unsigned window_ = 0;  ///< whose rows they are
  std::vector<RowPlace> rows_;
};

/// Notes that a row begins here, for the KeptPlace whose window this is; elsewhere it does nothing.
/// `name`: tells it from others of the window.
void mark_row(std::string_view name);

}  // namespace aucast::gui
