#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast::protocol {

/// Who may bring streams to a server, by tokens that are not those of viewers.
class Publishers {
 public:
  struct Publisher {
    std::string token;
    std::vector<std::string> names;  ///< of the streams that it may bring; empty: any
  };
  enum class Verdict : std::uint8_t { Welcome, OtherNames, Unknown };

  explicit Publishers(std::vector<Publisher> all) : all_(std::move(all)) {}

  /// Whether whoever shows the token may bring a stream of that name. Compares it with all tokens,
  /// and takes the same time wherever it finds it.
  [[nodiscard]] Verdict verdict(std::string_view token, std::string_view name) const;
  [[nodiscard]] const std::vector<Publisher>& all() const { return all_; }

 private:
  std::vector<Publisher> all_;
};

struct PublisherFile {
  Publishers publishers;
  /// For the log: other users have access to the file; else empty.
  std::string warning;
};

/// Reads a file with one publisher per line: its token and, after blanks, the names of the streams
/// that it may bring; no names: any. Empty lines and lines that begin with # are skipped.
/// Unreadable, or BadData with the line if one is malformed, a token is there twice, or there is
/// none; no message quotes a token.
[[nodiscard]] Result<PublisherFile> read_publisher_file(const std::filesystem::path& path);

}  // namespace aucast::protocol
