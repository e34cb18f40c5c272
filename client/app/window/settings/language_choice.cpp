#include "client/app/window/settings/language_choice.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include <spdlog/spdlog.h>

#include "client/gui/storage/language_file.h"
#include "client/gui/texts/texts.h"
#include "common/text.h"

namespace aucast::app {
namespace {

constexpr const char* kEnglishCode = "en";

std::filesystem::path folder_in(const std::filesystem::path& data) {
  return data / "languages";
}

}  // namespace

std::string language_of_locale(const char* lc_all, const char* lc_messages, const char* lang) {
  for (const char* one : {lc_all, lc_messages, lang}) {
    if (one == nullptr || *one == 0) continue;
    const std::string_view locale = one;
    const std::string_view language = locale.substr(0, locale.find_first_of("_.@"));
    if (language == "C" || language == "POSIX") break;
    return std::string(language);
  }
  return kEnglishCode;
}

std::string language_of_locale() {
  return language_of_locale(std::getenv("LC_ALL"), std::getenv("LC_MESSAGES"), std::getenv("LANG"));
}

std::vector<gui::LanguageEntry> languages_in(const std::filesystem::path& data) {
  std::vector<gui::LanguageEntry> languages{{kEnglishCode, "English"}};
  std::error_code failed;
  for (std::filesystem::directory_iterator at(folder_in(data), failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::filesystem::path& file = at->path();
    if (file.extension() != ".toml") continue;
    const auto loaded = gui::load_language(file);
    if (loaded) languages.push_back({file.stem().string(), loaded->language.name});
  }
  std::sort(languages.begin(), languages.end(),
            [](const auto& a, const auto& b) { return a.code < b.code; });
  return languages;
}

Result<void> choose_language(const std::filesystem::path& data, const std::string& code) {
  if (code == kEnglishCode) {
    gui::use_english();
    return {};
  }
  const std::filesystem::path file = folder_in(data) / (code + ".toml");
  std::error_code ignored;
  if (code.find('/') != std::string::npos || !std::filesystem::is_regular_file(file, ignored)) {
    std::string known;
    for (const gui::LanguageEntry& one : languages_in(data)) {
      known += (known.empty() ? "" : ", ") + one.code;
    }
    return Error{ErrorKind::Usage,
                 "the window has no language '" + escaped(code) + "'; there are " + known};
  }
  auto loaded = gui::load_language(file);
  if (!loaded) return loaded.error();
  for (const std::string& text : loaded->left_out) spdlog::warn("{}; the text is English", text);
  gui::use_language(std::move(loaded->language));
  return {};
}

}  // namespace aucast::app
