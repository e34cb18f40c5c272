#pragma once

#include <filesystem>
#include <vector>

#include "common/result.h"

namespace aucast {

/// Refuses to write over what is read: fails with Usage if one of `outputs` is a file that is also
/// one of `inputs`, by its own name or by that of a link. What is empty or not there is no file. Of
/// the inputs "-" is standard input, of the outputs standard output.
[[nodiscard]] Result<void> check_not_read(const std::vector<std::filesystem::path>& outputs,
                                          const std::vector<std::filesystem::path>& inputs);

/// Refuses to write one file twice: fails with Usage if two of `outputs` name the same file,
/// whether or not it is there. Empty ones, "-" and what is no regular file, such as /dev/null, may
/// be named twice.
[[nodiscard]] Result<void> check_distinct(const std::vector<std::filesystem::path>& outputs);

}  // namespace aucast
