#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/gui_model.h"
#include "common/result.h"

namespace aucast::app {

/// The language of a locale's name, which is the first of these that is set and not empty: "fr" of
/// "fr_CA.UTF-8"; "en" for none, "C" and "POSIX". Null: unset.
[[nodiscard]] std::string language_of_locale(const char* lc_all, const char* lc_messages,
                                             const char* lang);
/// The same of the environment.
[[nodiscard]] std::string language_of_locale();

/// English, and every file of `data`/languages that can be read, by their codes.
[[nodiscard]] std::vector<gui::LanguageEntry> languages_in(const std::filesystem::path& data);

/// From now on the window is in this language. Usage when there is none of that code, BadData
/// "file:line:column: ..." when its file is not whole; the language stays what it was then.
[[nodiscard]] Result<void> choose_language(const std::filesystem::path& data,
                                           const std::string& code);

}  // namespace aucast::app
