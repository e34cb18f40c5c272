#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/manual.h"
#include "common/result.h"

namespace aucast::server {

/// What a conversion leaves to say.
struct Converted {
  std::string text;  ///< for stdout: the help page, or the stream file when out is "-"
  std::string said;  ///< for stderr: what was found and written; may be empty
};

/// Is told again and again how far the conversion is: "lecture.mp4: 12 s, 34 %".
using SayProgress = std::function<void(const std::string&)>;

/// `au-transmitter convert` from its arguments (without that word): reads a recording, a film or a
/// stream file and writes a stream file or, to a name in .csv, a table of OpenFace 2, whole or not
/// at all. Nothing is lost except what a stream file cannot hold (intensities are whole percents,
/// times whole milliseconds) and, in a table, the sides.
[[nodiscard]] Result<Converted> run_convert(std::vector<std::string> arguments,
                                            const SayProgress& say = {});

/// What --help and the manual page say of it.
[[nodiscard]] CommandPage convert_page();

}  // namespace aucast::server
