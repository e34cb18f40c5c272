#pragma once

#include <string_view>
#include <vector>

#include "client/gui/model/row_places.h"

namespace aucast::gui {

/// Keeps the row under the pointer in its place while rows above it come and go: a panel that has
/// been scrolled is scrolled by the height of those rows. If the pointer is elsewhere, the row at
/// the panel's upper edge keeps its place.
class KeptPlace {
 public:
  /// Call it in the window that scrolls, before its first row.
  void begin();
  /// Call it after the last row. Returns whether rows have moved; the next frame has them in place
  /// again.
  [[nodiscard]] bool end();

 private:
  unsigned window_ = 0;  ///< the window that has rows_
  std::vector<RowPlace> rows_;
};

/// Call it where a row begins. Notes the row for the KeptPlace of this window; in a window without
/// a KeptPlace, does nothing. `name`: tells the row from others of the window.
void mark_row(std::string_view name);

}  // namespace aucast::gui
