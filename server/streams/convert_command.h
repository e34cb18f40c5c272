#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/result.h"
#include "server/settings/source_options.h"

namespace aucast::server {

/// What `au-transmitter convert` is asked to do.
struct ConvertOptions {
  std::filesystem::path in;
  std::filesystem::path out;  ///< "-": stdout
  std::uint32_t keyframe_ms = 250;
  SourceOptions source;
  bool mend = false;  ///< the input is a stream file that may have been cut off
};

/// What a conversion leaves to say.
struct Converted {
  std::string text;  ///< for stdout: the help page, or the stream file when out is "-"
  std::string said;  ///< for stderr: what was found and written; may be empty
};

/// `au-transmitter convert` from its arguments (without that word): reads a recording or a stream
/// file and writes a stream file or, to a name in .csv, a table of OpenFace 2, whole or not at all.
/// Nothing is lost but what a stream file cannot say (intensities are whole percent, times whole
/// milliseconds) and, of a table, the sides.
[[nodiscard]] Result<Converted> run_convert(std::vector<std::string> arguments);

[[nodiscard]] std::string convert_help_text();

}  // namespace aucast::server
