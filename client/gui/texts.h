#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "client/gui/english.h"
#include "common/result.h"

namespace aucast::gui {

// The texts of the window by their keys. english.h is the table; another language is a file of
// data/languages with the same keys. A key that the table does not have does not compile.

/// The place of a text in the table.
class TextKey {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): tr("button.save") is what it is for.
  consteval TextKey(const char* key) : row_(row_of(key)) {}
  [[nodiscard]] constexpr std::size_t row() const { return row_; }
  /// How many places to fill in, written {name}, a text has.
  [[nodiscard]] consteval std::size_t places() const {
    std::size_t count = 0;
    for (const char c : std::string_view(kEnglish[row_].text)) count += c == '{' ? 1U : 0U;
    return count;
  }

 private:
  static consteval std::size_t row_of(std::string_view key) {
    std::size_t row = 0;
    while (key != kEnglish.at(row).key) ++row;
    return row;
  }

  std::size_t row_;
};

/// A text with so many places to fill in.
template <std::size_t Places>
class FilledKey {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): as above.
  consteval FilledKey(const char* key) : key_(key) {
    if (key_.places() != Places) throw "the text has another number of places";
  }
  [[nodiscard]] constexpr std::size_t row() const { return key_.row(); }

 private:
  TextKey key_;
};

/// A language of the window besides English.
struct Language {
  std::string name;                     ///< in itself: "Français"
  std::vector<std::string> texts;       ///< one for each row of kEnglish
  std::map<int, std::string> au_names;  ///< those of FACS
  std::map<int, std::string> au_looks;
  std::map<std::string, std::string> words;  ///< of the data files, by the English: "Happiness"

  bool operator==(const Language&) const = default;
};

/// Reads a file of data/languages. BadData "file:line:column: ..." when a text is missing, is one
/// too many, or has other places to fill in than the English one.
[[nodiscard]] Result<Language> load_language(const std::filesystem::path& file);

/// From now on all texts are of this language. What tr() gave before stays valid. Thread: the
/// player's.
void use_language(Language language);
void use_english();
/// A language other than English is used.
[[nodiscard]] bool other_language();

/// The text in the language that is used.
[[nodiscard]] const char* tr(TextKey key);

[[nodiscard]] inline std::string place_text(std::string_view text) {
  return std::string(text);
}
[[nodiscard]] inline std::string place_text(std::integral auto number) {
  return std::to_string(number);
}
/// The text of a row with its places filled in, in the order in which the English has them.
[[nodiscard]] std::string filled(std::size_t row, const std::vector<std::string>& values);

template <typename... Values>
requires(sizeof...(Values) > 0) [[nodiscard]] std::string
    tr(std::type_identity_t<FilledKey<sizeof...(Values)>> key, const Values&... values) {
  return filled(key.row(), {place_text(values)...});
}

/// The FACS name of an AU; `own` where FACS has none, or who made the AU calls it otherwise.
[[nodiscard]] std::string au_name(int number, const std::string& own = {});
/// What an AU looks like; `english` where the language does not say.
[[nodiscard]] std::string au_looks(int number, const std::string& english);
/// A word of a data file, such as the label of an expression; itself where the language has none.
[[nodiscard]] std::string data_word(const std::string& english);
/// "1 keyframe", "6 keyframes".
[[nodiscard]] std::string keyframes_text(std::size_t count);
/// All that the language that is used may write, for the font.
[[nodiscard]] std::vector<std::string> all_texts();

}  // namespace aucast::gui
