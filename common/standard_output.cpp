#include "common/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <utility>

#include "common/text.h"

namespace aucast {

Result<void> print_now(std::string_view text) {
  errno = 0;
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) == 0 && written == text.size() && std::ferror(stdout) == 0) return {};
  std::string sentence = "standard output cannot be written";
  if (errno != 0) sentence += ": " + system_reason(errno);
  return Error{ErrorKind::Failed, std::move(sentence)};
}

std::optional<std::string> read_output_path(const std::string& word, std::filesystem::path& out) {
  out = word == "-" ? "/dev/stdout" : word;
  return std::nullopt;
}

}  // namespace aucast
