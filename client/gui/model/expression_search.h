#pragma once

#include <string>

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

/// The AUs of an expression and who describes it; a line each.
[[nodiscard]] std::string in_words(const ExpressionButton& button);

/// Whether the label, the AUs, a FACS name of one of them or the source have the words that are
/// looked for, in small letters. Numbers of AUs may be typed with spaces between them.
[[nodiscard]] bool is_meant(const ExpressionButton& button, const std::string& words);

}  // namespace aucast::gui
