#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "common/result.h"

namespace aucast::app {

/// The language of the locale: "fr" for "fr_CA.UTF-8", "en" for "C", "POSIX" or none. The locale's
/// name is the first argument that is set and not empty; null: unset.
[[nodiscard]] std::string language_of_locale(const char* lc_all, const char* lc_messages,
                                             const char* lang);
/// The same, from the environment.
[[nodiscard]] std::string language_of_locale();

/// English, and all languages whose files in `data`/languages can be read, sorted by code.
[[nodiscard]] std::vector<gui::LanguageEntry> languages_in(const std::filesystem::path& data);

/// Sets the language of the window, and logs which of its texts cannot be used and stay English.
/// Fails with Usage if there is no language with that code, or with BadData "file:line:column: ..."
/// if its file is not a language file. The language then stays as it was.
[[nodiscard]] Result<void> choose_language(const std::filesystem::path& data,
                                           const std::string& code);

}  // namespace aucast::app
