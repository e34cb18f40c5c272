#pragma once

#include <string>
#include <vector>

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

/// Keeps the rows of a stream's AUs where they are while the stream plays: an AU that the stream
/// has had keeps its row, and a row that a rule has changed keeps room for naming the rule.
class SteadyRows {
 public:
  /// The rows to be drawn for `rows`, in the order of au_rows(). `stream`: the stream that they
  /// belong to; when it changes, all earlier rows are forgotten.
  const std::vector<AuRow>& with(const std::vector<AuRow>& rows, const std::string& stream);

 private:
  std::string stream_;
  std::vector<AuRow> kept_;
};

}  // namespace aucast::gui
