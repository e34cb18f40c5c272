#include "protocol/token_file.h"

#include <string_view>

#include "common/files.h"
#include "common/text.h"
#include "common/text_file.h"
#include "protocol/limits.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {

Result<TokenFile> read_token_file(const std::filesystem::path& path) {
  const auto file = read_secret_file(path, 2 * kTokenBytesMax);
  if (!file) return file.error();
  const auto wrong = [&path](const std::string& what) {
    return Error{ErrorKind::BadData, at_place(path.string(), what)};
  };
  constexpr std::string_view kAround = " \t\r\n";
  TokenFile token;
  token.word = trimmed(file->bytes, kAround);
  if (token.word.empty()) return wrong("the token file is empty");
  if (token.word.size() > kTokenBytesMax) {
    return wrong("the token is longer than " + std::to_string(kTokenBytesMax) + " bytes");
  }
  if (!is_field_value(token.word)) {
    return wrong("a token is one word of printable ASCII without braces");
  }
  if (file->open_to_others) {
    token.warning = at_place(path.string(), "other users have access to the token (chmod 600)");
  }
  return token;
}

}  // namespace aucast::protocol
