#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/result.h"
#include "common/toml_document.h"
#include "server/settings/option_table.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// The words of one option and where they were said.
struct Setting {
  enum class Layer : std::uint8_t { Default, File, Environment, CommandLine };

  std::vector<std::string> words;
  Layer layer = Layer::Default;
  std::string file;  ///< of Layer::File
  Place place;       ///< in it
};

/// What each option is set to, by name, whoever said it last: defaults, settings file, environment,
/// command line. Only options that are set are in it.
using Settings = std::map<std::string, Setting, std::less<>>;

[[nodiscard]] Settings default_settings();

/// Adds a settings file: TOML with one `name = value` an option. BadData with file:line:column for
/// what is no TOML, no option (with the nearest), or of another type.
[[nodiscard]] Result<void> add_file(Settings& settings, std::string_view text,
                                    const std::string& file);

/// NAME and value of every variable that concerns us or anybody else.
using Environment = std::vector<std::pair<std::string, std::string>>;

/// Adds the variables AUCAST_TRANSMITTER_<OPTION>; several words are separated by commas, an empty
/// one says nothing. Usage error for a variable of that kind which is no option.
[[nodiscard]] Result<void> add_environment(Settings& settings, const Environment& environment);

/// Reads all settings. The error names where the wrong word was said: usage, or BadData with
/// file:line:column for one of a file.
[[nodiscard]] Result<TransmitterOptions> options_of(const Settings& settings);

/// The settings as a settings file, with a comment on each where it is from.
[[nodiscard]] std::string print_config(const Settings& settings);

}  // namespace aucast::server
