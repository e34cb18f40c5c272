#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "common/result.h"

namespace aucast::gui {

struct LoadedLanguage {
  Language language;
  /// "file:line:column: ..." of the texts that are missing or unknown, or whose places to be filled
  /// in differ from those of the English text, which stays there; the first kReportedErrorsMax.
  std::vector<std::string> left_out;
};

/// Reads a file of data/languages. BadData "file:line:column: ..." if it is not TOML, or the name
/// of the language or a section is missing.
[[nodiscard]] Result<LoadedLanguage> load_language(const std::filesystem::path& file);

}  // namespace aucast::gui
