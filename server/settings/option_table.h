#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "server/settings/option_word.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// One option of au-transmitter. The command line, the environment, the settings file,
/// --print-config, --help, the manual page and the completion all come from the table of these.
struct OptionRow {
  enum class Kind : std::uint8_t {
    Flag,    ///< on the command line without a word; read with "true" or "false"
    Number,  ///< in a settings file a number, or a string
    Word,    ///< a string
    Words,   ///< several; read with one at a time
  };
  using Read = Complaint (*)(const std::string& word, TransmitterOptions& options);

  std::string_view name;      ///< without dashes; SOURCE's is "source"
  std::string_view argument;  ///< what stands for its word: "ADDR"; empty for a flag
  Kind kind = Kind::Word;
  std::string_view fallback;      ///< the default as a word; empty: not set
  std::string_view text;          ///< for --help; two short ones in a row share a line there
  std::string_view more;          ///< for the manual page: whole sentences
  Read read = nullptr;            ///< nothing: on the command line only, and none of the settings
  std::string_view heading = {};  ///< of the section that begins with this row; empty: goes on
};

/// All options, in the order of --help.
[[nodiscard]] std::span<const OptionRow> option_table();

/// The row of that name, or nothing.
[[nodiscard]] const OptionRow* find_option(std::string_view name);

/// How it is typed: "--port", "SOURCE".
[[nodiscard]] std::string typed_name(const OptionRow& row);

/// The variable of the environment: "AUCAST_TRANSMITTER_CLIENT_TIMEOUT".
[[nodiscard]] std::string variable_name(const OptionRow& row);

}  // namespace aucast::server
