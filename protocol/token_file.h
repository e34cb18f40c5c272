#pragma once

#include <filesystem>
#include <string>

#include "common/result.h"

namespace aucast::protocol {

/// A token as a hello shows it, from a file of one line.
struct TokenFile {
  std::string word;
  std::string warning;  ///< for the log: others on this computer can read the file; else empty
};

/// Reads the file: one word of printable ASCII without braces, at most kTokenBytesMax, blanks and
/// line ends around it left out. Unreadable, or BadData when it holds none or another thing; what
/// it holds is never part of a message.
[[nodiscard]] Result<TokenFile> read_token_file(const std::filesystem::path& path);

}  // namespace aucast::protocol
