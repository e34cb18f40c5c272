#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast {

/// Writes `text` to stdout at once, for a program that may be waiting at the other end of a pipe.
/// Fails with ErrorKind::Failed and the cause if this or earlier output cannot be written.
[[nodiscard]] Result<void> print_now(std::string_view text = {});

/// Reads the path of a file to be written, in which "-" is standard output. Never complains: it
/// returns nullopt, as an option's parse function that has taken its word (options.h).
[[nodiscard]] std::optional<std::string> read_output_path(const std::string& word,
                                                          std::filesystem::path& out);

}  // namespace aucast
