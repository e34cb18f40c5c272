#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast::protocol {

/// Who may bring streams to a server. Publishers have tokens of their own, not the viewers'.
class Publishers {
 public:
  struct Publisher {
    std::string token;
    std::vector<std::string> names;  ///< names of the streams that it may bring; empty: any
  };
  enum class Verdict : std::uint8_t { Welcome, OtherNames, Unknown };

  explicit Publishers(std::vector<Publisher> all) : all_(std::move(all)) {}

  /// Whether the owner of this token may bring a stream of this name. Always compares the token
  /// with those of all publishers, so that the time it takes gives nothing away.
  [[nodiscard]] Verdict verdict(std::string_view token, std::string_view name) const;
  [[nodiscard]] const std::vector<Publisher>& all() const { return all_; }

 private:
  std::vector<Publisher> all_;
};

struct PublisherFile {
  Publishers publishers;
  /// A sentence for the log when other users have access to the file; else empty.
  std::string warning;
};

/// Reads a file with one publisher per line: its token and, after blanks, the names of the streams
/// that it may bring (without names, any). Empty lines and lines that begin with # are skipped.
/// Fails with Unreadable, or with BadData if a line is malformed, a token occurs twice (these
/// errors name the line) or there is no publisher. No message quotes a token.
[[nodiscard]] Result<PublisherFile> read_publisher_file(const std::filesystem::path& path);

}  // namespace aucast::protocol
