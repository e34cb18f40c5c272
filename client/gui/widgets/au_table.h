#pragma once

#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/gui/widgets/widgets.h"

namespace aucast::gui {

/// The texts around a table of AUs: the heading and tip of the first column (the AUs as they came),
/// a legend, and the tip of the second column.
struct AuTableWords {
  const char* given = "";
  const char* given_tip = "";
  const char* legend = "";
  const char* shown_tip = "";
};
void au_table(const Look& look, const AuTableWords& words, const std::vector<AuRow>& rows);

}  // namespace aucast::gui
