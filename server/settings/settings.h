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

/// Name and value of every environment variable.
using Environment = std::vector<std::pair<std::string, std::string>>;

/// What each option is set to, and by what: defaults, settings file, environment and command line,
/// each of which wins over those before it. Options that are for the command line only are read
/// too, but are not settings.
class Settings {
 public:
  /// `rows` must outlive it.
  explicit Settings(const std::vector<OptionRow>& rows);

  /// Adds a settings file: TOML with one `name = value` per option. Fails with BadData and
  /// file:line:column for text that is not TOML, an unknown option (the message names the nearest)
  /// or a value of the wrong type.
  [[nodiscard]] Result<void> add_file(std::string_view text, const std::string& file);

  /// Adds the variables AUCAST_TRANSMITTER_<OPTION>; several words are separated by commas, an
  /// empty value is ignored. Fails with a Usage error for a variable that begins like this but
  /// names no option.
  [[nodiscard]] Result<void> add_environment(const Environment& environment);

  /// Adds the command line.
  void add_typed(const TypedWords& typed);

  /// Reads all words into the variables to which the rows are bound. Fails for a wrong word with a
  /// Usage error that names where the word comes from, or, for a word in a file, with BadData and
  /// file:line:column.
  [[nodiscard]] Result<void> read() const;

  /// The settings as a settings file, with a comment on where each comes from.
  [[nodiscard]] std::string print() const;

 private:
  enum class Origin : std::uint8_t { Default, File, Variable, CommandLine };

  /// The words of one option, and where they come from.
  struct Setting {
    std::vector<std::string> words;
    Origin origin = Origin::Default;
    std::string file = {};    ///< if Origin::File
    LinePosition place = {};  ///< in that file
  };

  /// The error about a wrong word, which depends on where it comes from.
  [[nodiscard]] static Error wrong(const OptionRow& row, const Setting& setting,
                                   const std::string& word, const std::string& complaint);
  [[nodiscard]] static std::string value_text(const OptionRow& row, const Setting& setting);
  [[nodiscard]] static std::string origin(const OptionRow& row, const Setting& setting);

  const std::vector<OptionRow>& rows_;
  std::map<std::string, Setting, std::less<>> settings_;  ///< by name; only those that are set
};

}  // namespace aucast::server
