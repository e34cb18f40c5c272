#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/manual.h"
#include "common/result.h"

namespace aucast::server {

/// The output of a conversion.
struct Converted {
  std::string text;  ///< for stdout: the help page, or the stream file if its path is "-"
  std::string said;  ///< for stderr: what was found and written; may be empty
};

/// Called again and again with the progress of a conversion: "lecture.mp4: 12 s, 34 %".
using SayProgress = std::function<void(const std::string&)>;

/// Runs `au-transmitter convert` with its arguments (without that word): reads a recording, a film
/// or a stream file and writes (whole or not at all) a stream file or, if its name ends in .csv, a
/// table of OpenFace 2. Only this is lost: intensities become whole percents, times become whole
/// milliseconds, and a table does not tell sides apart.
[[nodiscard]] Result<Converted> run_convert(std::vector<std::string> arguments,
                                            const SayProgress& say = {});

/// The texts of --help and the manual page about converting.
[[nodiscard]] CommandPage convert_page();

}  // namespace aucast::server
