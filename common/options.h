#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/number_of.h"
#include "common/result.h"
#include "common/text.h"

namespace aucast {

/// What is wrong with an option's word, that is, its value as typed. Messages put the complaint
/// after the option's name and the word: "is not a whole number from 0 to 65535". nullopt: the word
/// is right.
using Complaint = std::optional<std::string>;

/// How the words of an option become the value of a variable.
struct OptionValue {
  enum class Kind : std::uint8_t {
    Flag,    ///< typed without a word; read() gets "true" or "false"
    Number,  ///< a number or a string in a settings file
    Word,    ///< a string
    Words,   ///< several; read() gets one at a time
  };
  Kind kind = Kind::Word;
  /// Stores the word's value, or returns a complaint. Empty: the option is bound to no variable,
  /// and the program looks for it in the TypedWords.
  std::function<Complaint(const std::string& word)> read = {};
};

/// One option of a program, bound to a variable that must outlive the row. The command line, the
/// environment, the settings file, --print-config, --help, the manual page and the completion all
/// come from lists of such rows.
struct OptionRow {
  enum class Where : std::uint8_t {
    Anywhere,    ///< on the command line and wherever else the program takes settings from
    Typed,       ///< on the command line only: it is not a setting
    Positional,  ///< as Anywhere, but typed without its name; --help shows its `argument`
  };

  /// For example "port", "N", "4650".
  struct Option {
    std::string_view name = {};      ///< without dashes
    std::string_view argument = {};  ///< stands for its word in --help; empty for a flag
    std::string_view fallback = {};  ///< the default as a word; empty: not set, or a flag's false
  };

  Option option = {};
  std::string_view text = {};  ///< for --help: one line; empty: only in the manual page
  std::string_view more = {};  ///< for the manual page: whole sentences; empty: `text`
  OptionValue value = {};
  std::string_view heading = {};  ///< a section with this heading begins here; empty: none does
  Where where = Where::Anywhere;
  char letter = 0;  ///< its short form: 'v' for -v; 0: none
};

/// How the option is typed: "--port", "SOURCE".
[[nodiscard]] std::string typed_name(const OptionRow& row);

/// The row of that name; null: there is none.
[[nodiscard]] const OptionRow* find_row(const std::vector<OptionRow>& rows, std::string_view name);

/// Copies of the rows that are bound to no variable, for their descriptions alone.
[[nodiscard]] std::vector<OptionRow> unbound(std::vector<OptionRow> rows);

/// Adds `more` to the end of `rows`.
void append(std::vector<OptionRow>& rows, std::vector<OptionRow> more);

/// What was typed: the words of each row that was used, by the row's name. A flag has one "true" or
/// "false" for each time it was typed.
using TypedWords = std::map<std::string, std::vector<std::string>, std::less<>>;

/// Sorts the arguments (without the program's name) by row. Fails with a usage error of one line
/// for an unknown option (the line names the nearest known one), a missing word or a word too many.
[[nodiscard]] Result<TypedWords> sort_arguments(const std::vector<OptionRow>& rows,
                                                std::vector<std::string> arguments);

/// Reads words into the variables of the rows, in the order of the rows. Fails with a Usage error
/// for the first word that is wrong.
[[nodiscard]] Result<void> read_words(const std::vector<OptionRow>& rows, const TypedWords& words);

/// Reads one word into the row's variable. Always complains about an empty word, which is what
/// `--stats "$UNSET"` passes.
[[nodiscard]] Complaint read_word(const OptionRow& row, const std::string& word);

/// A usage error that points to the help: "`message` (try --help)".
[[nodiscard]] Error usage_error(const std::string& message);

/// A usage error about a word, such as "--port 'x' is not a whole number ... (try --help)".
[[nodiscard]] Error wrong_word(const std::string& name, const std::string& word,
                               const std::string& complaint);

// === Values

/// A flag that sets `out` to `given`, or, with the word "false", to the opposite of `given`.
[[nodiscard]] OptionValue flag(bool& out, bool given = true);

/// A flag bound to no variable: the program looks for it in what was typed.
[[nodiscard]] OptionValue flag();

/// The rows of --help and --version, bound to no variable.
[[nodiscard]] std::vector<OptionRow> help_rows();

/// A whole number from `low` to `high`. `out` may be a number, an optional, or a duration, whose
/// unit is then the option's.
template <typename T>
[[nodiscard]] OptionValue whole(T& out, std::int64_t low, std::int64_t high) {
  return {OptionValue::Kind::Number, [&out, low, high](const std::string& word) -> Complaint {
            const auto value = number_of<std::int64_t>(word);
            if (!value || *value < low || *value > high) {
              return "is not a whole number from " + std::to_string(low) + " to " +
                     std::to_string(high);
            }
            out = T(*value);
            return std::nullopt;
          }};
}

/// A number from `low` to `high`; `complaint` is the complaint about anything else.
template <typename T>
[[nodiscard]] OptionValue real(T& out, double low, double high, std::string_view complaint) {
  return {OptionValue::Kind::Number, [&out, low, high, complaint](const std::string& word) {
            const auto value = number_of<double>(word);
            if (!value || !(*value >= low && *value <= high)) return Complaint(complaint);
            out = *value;
            return Complaint();
          }};
}

/// Seconds from `low` to `high`, rounded to milliseconds; a positive value never becomes 0.
/// `complaint` is the complaint about anything else.
template <typename T>
[[nodiscard]] OptionValue seconds(T& out, double low, double high, std::string_view complaint) {
  return {OptionValue::Kind::Number, [&out, low, high, complaint](const std::string& word) {
            const auto value = number_of<double>(word);
            if (!value || !(*value >= low && *value <= high)) return Complaint(complaint);
            const std::chrono::duration<double> exact(*value);
            const auto rounded = std::chrono::round<std::chrono::milliseconds>(exact);
            out = rounded.count() == 0 && *value > 0 ? std::chrono::milliseconds(1) : rounded;
            return Complaint();
          }};
}

/// Any word: a name, a path.
template <typename T>
[[nodiscard]] OptionValue word(T& out) {
  return {OptionValue::Kind::Word, [&out](const std::string& typed) {
            out = typed;
            return Complaint();
          }};
}

/// Any number of words: the option may be repeated.
template <typename T>
[[nodiscard]] OptionValue words(std::vector<T>& out) {
  return {OptionValue::Kind::Words, [&out](const std::string& typed) {
            out.emplace_back(typed);
            return Complaint();
          }};
}

/// A word that the option's own function `parse` reads.
template <typename T>
[[nodiscard]] OptionValue parsed(OptionValue::Kind kind,
                                 Complaint (*parse)(const std::string& word, T& out), T& out) {
  return {kind, [parse, &out](const std::string& typed) { return parse(typed, out); }};
}

/// One of some names, each with the value that it stands for.
template <typename T>
[[nodiscard]] OptionValue one_of(T& out, std::vector<std::pair<std::string_view, T>> choices) {
  return {OptionValue::Kind::Word,
          [&out, choices = std::move(choices)](const std::string& typed) -> Complaint {
            std::string names;
            for (const auto& [name, value] : choices) {
              names += (names.empty() ? "" : ", ") + std::string(name);
              if (name != typed) continue;
              out = value;
              return std::nullopt;
            }
            return "is not one of " + names;
          }};
}

/// One of some names, kept as it was typed.
[[nodiscard]] OptionValue one_of(std::string& out, const std::vector<std::string_view>& names);

/// The names of log levels.
[[nodiscard]] OptionValue log_level(std::string& out);

/// Puts the level that the flags --verbose and --quiet stand for where --log-level was typed,
/// unless that was typed too. --quiet is "error"; `verbose` has the levels of -v, -vv and so on.
/// Fails with a Usage error if both flags were typed.
[[nodiscard]] Result<void> apply_verbosity(TypedWords& typed,
                                           const std::vector<std::string>& verbose);

}  // namespace aucast
