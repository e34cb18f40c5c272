#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "common/result.h"

namespace aucast::gui {

struct LoadedLanguage {
  Language language;
  /// One complaint, "file:line:column: ...", for each text that cannot be used because it is
  /// missing or unknown, or has other places to be filled in than the English text. There are at
  /// most kReportedErrorsMax complaints. Such a text stays English.
  std::vector<std::string> left_out;
};

/// Reads a file of data/languages. Fails with BadData "file:line:column: ..." if it is not TOML, or
/// the name of the language or a section is missing.
[[nodiscard]] Result<LoadedLanguage> load_language(const std::filesystem::path& file);

}  // namespace aucast::gui
