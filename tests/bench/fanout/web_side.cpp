#include "tests/bench/fanout/web_side.h"

#include <cstddef>

#include "common/web/upgrade.h"
#include "tests/support/web_frames.h"

namespace aucast::bench {
namespace {

constexpr const char* kKey = "dGhlIHNhbXBsZSBub25jZQ==";
constexpr std::string_view kEndOfHead = "\r\n\r\n";
constexpr unsigned char kText = 0x81;
constexpr unsigned char kPing = 0x89;
constexpr unsigned char kPong = 0x8a;
constexpr std::size_t kLength16 = 126;

std::size_t byte_at(std::string_view wire, std::size_t place) {
  return static_cast<unsigned char>(wire[place]);
}

}  // namespace

std::string WebSide::upgrade() {
  return std::string(
             "GET /aucast HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\n"
             "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ") +
         kKey + std::string(kEndOfHead);
}

bool WebSide::received(std::string_view wire, const std::string& greeting, std::string& text,
                       std::string& answer) {
  held_ += wire;
  if (!agreed_ && !take_agreement(greeting, answer)) {
    return held_.find(kEndOfHead) == std::string::npos;
  }
  std::string_view rest = held_;
  while (rest.size() >= 2) {
    const std::size_t said = byte_at(rest, 1);
    const std::size_t head = said < kLength16 ? 2 : 4;
    if (said > kLength16 || rest.size() < head) break;
    const std::size_t size = head == 2 ? said : byte_at(rest, 2) << 8U | byte_at(rest, 3);
    if (rest.size() < head + size) break;
    const auto kind = static_cast<unsigned char>(rest[0]);
    if (kind == kText) text += rest.substr(head, size);
    if (kind == kPing) answer += test::client_frame(kPong, rest.substr(head, size));
    if (kind != kText && kind != kPing) return false;
    rest.remove_prefix(head + size);
  }
  held_.erase(0, held_.size() - rest.size());
  return true;
}

/// The reply to the upgrade; false as long as it is not complete, or if it does not agree.
bool WebSide::take_agreement(const std::string& greeting, std::string& answer) {
  const std::size_t end = held_.find(kEndOfHead);
  if (end == std::string::npos) return false;
  const std::string accept = "Sec-WebSocket-Accept: " + web::accept_key(kKey);
  agreed_ = held_.starts_with("HTTP/1.1 101 ") && held_.find(accept) < end;
  if (!agreed_) return false;
  held_.erase(0, end + kEndOfHead.size());
  answer += test::client_text(greeting);
  return true;
}

}  // namespace aucast::bench
