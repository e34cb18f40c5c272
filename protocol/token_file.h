#pragma once

#include <filesystem>
#include <string>

#include "common/result.h"

namespace aucast::protocol {

/// A token as a hello shows it, from a file of one line.
struct TokenFile {
  std::string word;
  /// For the log: everybody on this computer can use the file; else empty. A group may, for a
  /// service is often let in as one.
  std::string warning;
};

/// Reads the file: one word of printable ASCII without braces, at most kTokenBytesMax, blanks and
/// line ends around it left out. Unreadable, or BadData when it holds none or another thing; what
/// it holds is never part of a message.
[[nodiscard]] Result<TokenFile> read_token_file(const std::filesystem::path& path);

}  // namespace aucast::protocol
