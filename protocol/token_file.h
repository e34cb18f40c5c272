#pragma once

#include <filesystem>
#include <string>

#include "common/result.h"

namespace aucast::protocol {

/// A token as sent in a hello.
struct TokenFile {
  std::string word;
  /// A sentence for the log when other users have access to the file; else empty.
  std::string warning;
};

/// Reads a file with one word of printable ASCII without braces, of at most kTokenBytesMax bytes;
/// white space around it is ignored. Fails with Unreadable, or with BadData when the file is empty
/// or has anything else. No message quotes the token.
[[nodiscard]] Result<TokenFile> read_token_file(const std::filesystem::path& path);

}  // namespace aucast::protocol
