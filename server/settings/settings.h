#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/options.h"
#include "common/result.h"
#include "common/toml_document.h"

namespace aucast::server {

/// NAME and value of every variable that concerns us or anybody else.
using Environment = std::vector<std::pair<std::string, std::string>>;

/// What each option is set to, and by what: defaults, settings file, environment or command line,
/// of which the last wins. Options that are for the command line only are read too, but are not
/// settings.
class Settings {
 public:
  /// `rows` must outlive it.
  explicit Settings(const std::vector<OptionRow>& rows);

  /// Adds a settings file: TOML with one `name = value` per option. BadData with file:line:column
  /// for what is no TOML, no option (with the nearest), or of another type.
  [[nodiscard]] Result<void> add_file(std::string_view text, const std::string& file);

  /// Adds the variables AUCAST_TRANSMITTER_<OPTION>; several words are separated by commas, an
  /// empty one says nothing. Usage error for a variable of that kind which is no option.
  [[nodiscard]] Result<void> add_environment(const Environment& environment);

  /// Adds what was typed.
  void add_typed(const TypedWords& typed);

  /// Reads all words into what the rows are bound to. The error names where the wrong word was
  /// said: usage, or BadData with file:line:column for one of a file.
  [[nodiscard]] Result<void> read() const;

  /// The settings as a settings file, with a comment on each where it is from.
  [[nodiscard]] std::string print() const;

 private:
  enum class Layer : std::uint8_t { Default, File, Variable, CommandLine };

  /// The words of one option and where they were said.
  struct Setting {
    std::vector<std::string> words;
    Layer layer = Layer::Default;
    std::string file = {};    ///< of Layer::File
    LinePosition place = {};  ///< in it
  };

  /// What is said about a wrong word, by where it was said.
  [[nodiscard]] static Error wrong(const OptionRow& row, const Setting& setting,
                                   const std::string& word, const std::string& complaint);
  [[nodiscard]] static std::string value_text(const OptionRow& row, const Setting& setting);
  [[nodiscard]] static std::string origin(const OptionRow& row, const Setting& setting);

  const std::vector<OptionRow>& rows_;
  std::map<std::string, Setting, std::less<>> settings_;  ///< by name; only those that are set
};

}  // namespace aucast::server
