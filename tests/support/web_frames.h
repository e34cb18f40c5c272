#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace aucast::test {

/// One frame of a WebSocket client; it may break the rules. `first`: the byte with FIN and
/// opcode, 0x81 for a whole text.
inline std::string client_frame(unsigned char first, std::string_view payload,
                                std::string_view mask = "\x12\x34\x56\x78") {
  std::string frame(1, static_cast<char>(first));
  const std::uint64_t size = payload.size();
  const int bytes = size < 126 ? 0 : size <= 0xffff ? 2 : 8;
  const std::uint64_t length = bytes == 0 ? size : bytes == 2 ? 126 : 127;
  frame += static_cast<char>(0x80U | length);
  for (int i = bytes - 1; i >= 0; --i) frame += static_cast<char>(size >> (8 * i) & 0xffU);
  frame += mask;
  for (std::size_t i = 0; i < payload.size(); ++i) {
    frame += static_cast<char>(payload[i] ^ mask[i % mask.size()]);
  }
  return frame;
}

inline std::string client_text(std::string_view text) {
  return client_frame(0x81, text);
}

/// A server's frame of less than 126 bytes.
inline std::string server_frame(unsigned char first, std::string_view payload) {
  return std::string(1, static_cast<char>(first)) + static_cast<char>(payload.size()) +
         std::string(payload);
}

inline std::string server_text(std::string_view text) {
  return server_frame(0x81, text);
}

/// A server's Close.
inline std::string server_close(int code) {
  return server_frame(0x88, std::string{static_cast<char>(code >> 8), static_cast<char>(code)});
}

}  // namespace aucast::test
