#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/texts/texts.h"
#include "common/result.h"

namespace aucast::gui {

struct LoadedLanguage {
  Language language;
  /// The texts of the file that are not used, each as "file:line:column: ...", at most
  /// kReportedErrorsMax: a text is missing or unknown, or differs from the English text in the
  /// places to be filled in. Such a text stays English.
  std::vector<std::string> left_out;
};

/// Reads a file of data/languages. Fails with BadData "file:line:column: ..." if it is not TOML, or
/// the name of the language or a section is missing.
[[nodiscard]] Result<LoadedLanguage> load_language(const std::filesystem::path& file);

}  // namespace aucast::gui
