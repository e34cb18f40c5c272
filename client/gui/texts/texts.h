#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "client/gui/texts/english.h"

namespace aucast::gui {

// The texts of the window by their keys. english.h has the table; another language is a file of
// data/languages with the same keys. A key that is not in the table does not compile.

/// The place of a text in the table.
class TextKey {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): tr("button.save") is what it is for.
  consteval TextKey(const char* key) : row_(row_of(key)) {}
  [[nodiscard]] constexpr std::size_t row() const { return row_; }
  /// How many places to be filled in, written {name}, the text has.
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

/// A text with this many places to be filled in.
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
  std::string name;                     ///< the language's own name: "Français"
  std::vector<std::string> texts;       ///< one for each row of kEnglish
  std::map<int, std::string> au_names;  ///< FACS names by AU number
  std::map<int, std::string> au_looks;
  std::map<std::string, std::string> words;  ///< translations of words of the data files, by the
                                             ///< English word, such as "Happiness"

  bool operator==(const Language&) const = default;
};

/// Uses this language for all texts from now on. What tr() returned before stays valid. Thread: the
/// player's.
void use_language(Language language);
void use_english();
/// Whether a language other than English is in use.
[[nodiscard]] bool other_language();

/// The text in the language in use.
[[nodiscard]] const char* tr(TextKey key);

[[nodiscard]] inline std::string place_text(std::string_view text) {
  return std::string(text);
}
[[nodiscard]] inline std::string place_text(std::integral auto number) {
  return std::to_string(number);
}
/// The names of the places to be filled in, in their order.
[[nodiscard]] std::vector<std::string_view> places_of(std::string_view text);

/// The text of a row of the table with its places filled in. `values`: in the order of the English
/// text.
[[nodiscard]] std::string filled(std::size_t row, const std::vector<std::string>& values);

template <typename... Values>
requires(sizeof...(Values) > 0) [[nodiscard]] std::string
    tr(std::type_identity_t<FilledKey<sizeof...(Values)>> key, const Values&... values) {
  return filled(key.row(), {place_text(values)...});
}

/// The name of an AU to show. `own`: the name that its author gave it, which is used unless it is
/// empty or equals the FACS name.
[[nodiscard]] std::string au_name(int number, const std::string& own = {});
/// What an AU looks like; `english` if the language has no text for it.
[[nodiscard]] std::string au_looks(int number, const std::string& english);
/// The translation of a word of a data file, such as an expression's label; the word itself if
/// there is none.
[[nodiscard]] std::string data_word(const std::string& english);
/// "1 keyframe", "6 keyframes".
[[nodiscard]] std::string keyframes_text(std::size_t count);
/// All texts of the language in use, from which the font takes its letters.
[[nodiscard]] std::vector<std::string> all_texts();

}  // namespace aucast::gui
