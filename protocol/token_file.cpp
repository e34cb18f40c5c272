#include "protocol/token_file.h"

#include <string_view>
#include <system_error>

#include "common/files.h"
#include "common/text_file.h"
#include "protocol/limits.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {

Result<TokenFile> read_token_file(const std::filesystem::path& path) {
  auto text = read_file(path, 2 * kTokenBytesMax);
  if (!text) return text.error();
  const auto wrong = [&path](const std::string& what) {
    return Error{ErrorKind::BadData, path.string() + ": " + what};
  };
  constexpr std::string_view kBlanks = " \t\r\n";
  TokenFile token;
  token.word = trimmed(*text, kBlanks);
  if (token.word.empty()) return wrong("the token file is empty");
  if (token.word.size() > kTokenBytesMax) {
    return wrong("the token is longer than " + std::to_string(kTokenBytesMax) + " bytes");
  }
  if (!is_field_value(token.word)) {
    return wrong("a token is one word of printable ASCII without braces");
  }
  std::error_code ignored;
  using std::filesystem::perms;
  const auto status = std::filesystem::status(path, ignored);
  if (!ignored && (status.permissions() & perms::others_all) != perms::none) {
    token.warning = path.string() + ": others on this computer can use the token (chmod 600)";
  }
  return token;
}

}  // namespace aucast::protocol
