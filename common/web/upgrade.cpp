#include "common/web/upgrade.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "common/check.h"

namespace aucast::web {
namespace {

constexpr std::string_view kGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
constexpr std::size_t kSha1Bytes = 20;

/// 16 bytes in base64.
bool is_key(std::string_view key) {
  constexpr std::size_t kDigits = 22;
  return key.size() == kDigits + 2 && key.ends_with("==") &&
         std::all_of(key.begin(), key.begin() + kDigits, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '/';
         });
}

HttpReply upgrade_required(std::string why) {
  return {.status = 426,
          .body = std::move(why),
          .fields = {"Upgrade: websocket", "Sec-WebSocket-Version: 13"}};
}

}  // namespace

std::optional<HttpReply> refuse_upgrade(const HttpRequest& request) {
  const bool asks = request.version_1_1 && !request.head &&
                    has_word(request.field("upgrade"), "websocket") &&
                    has_word(request.field("connection"), "upgrade");
  if (!asks) return upgrade_required("a WebSocket is served here: ask for one (RFC 6455)\n");
  if (request.field("sec-websocket-version") != "13") {
    return upgrade_required("only version 13 of WebSocket is spoken here (RFC 6455)\n");
  }
  if (is_key(request.field("sec-websocket-key"))) return std::nullopt;
  return HttpReply{.status = 400,
                   .body = "Sec-WebSocket-Key must be 16 bytes in base64 (RFC 6455)\n"};
}

std::string accept_upgrade(const HttpRequest& request) {
  return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Accept: " +
         accept_key(request.field("sec-websocket-key")) + "\r\n\r\n";
}

std::string accept_key(std::string_view key) {
  const std::string text = std::string(key) + std::string(kGuid);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  AUCAST_CHECK(EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha1(), nullptr) ==
               1);
  AUCAST_CHECK(size == kSha1Bytes);
  std::array<unsigned char, 4 * ((kSha1Bytes + 2) / 3) + 1> base64{};  // and the zero behind it
  const int length = EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(size));
  return {base64.begin(), base64.begin() + length};
}

}  // namespace aucast::web
