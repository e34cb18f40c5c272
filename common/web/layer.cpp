#include "common/web/layer.h"

#include <algorithm>
#include <utility>

namespace aucast::web {
namespace {

enum Opcode : unsigned char {
  kContinuation = 0,
  kText = 1,
  kBinary = 2,
  kClose = 8,
  kPing = 9,
  kPong = 10,
};

// Of the first byte of a frame, and of the second.
constexpr unsigned char kFinal = 0x80;
constexpr unsigned char kReserved = 0x70;
constexpr unsigned char kOpcode = 0x0f;
constexpr unsigned char kMasked = 0x80;
constexpr unsigned char kLength = 0x7f;

// Lengths in the second byte that stand for a longer one in the next 2 or 8 bytes.
constexpr unsigned char kLength16 = 126;
constexpr unsigned char kLength64 = 127;

constexpr std::size_t kMaskBytes = 4;
constexpr std::size_t kControlBytesMax = 125;

// Why a WebSocket is closed.
constexpr int kNormal = 1000;
constexpr int kProtocolError = 1002;
constexpr int kNotAcceptable = 1003;
constexpr int kNotText = 1007;
constexpr int kTooBig = 1009;

/// Whether a Close may have this code (RFC 6455, 7.4).
bool is_close_code(int code) {
  return (code >= 1000 && code <= 1003) || (code >= 1007 && code <= 1014) ||
         (code >= 3000 && code <= 4999);
}

std::size_t length_bytes(unsigned char length) {
  if (length == kLength16) return 2;
  return length == kLength64 ? 8 : 0;
}

/// One frame, not masked: a server's.
void append_frame(std::string& wire, Opcode opcode, std::string_view payload) {
  wire += static_cast<char>(kFinal | opcode);
  const std::size_t size = payload.size();
  int more_bytes = 0;
  if (size < kLength16) {
    wire += static_cast<char>(size);
  } else {
    more_bytes = size <= 0xffff ? 2 : 8;
    wire += static_cast<char>(more_bytes == 2 ? kLength16 : kLength64);
  }
  for (int byte = more_bytes - 1; byte >= 0; --byte) {
    wire += static_cast<char>((std::uint64_t{size} >> (8 * byte)) & 0xffU);
  }
  wire += payload;
}

}  // namespace

bool Layer::received(std::string_view wire, std::string& text) {
  while (!failed() && !closed_) {
    if (in_payload_) {
      take_payload(wire, text);
      if (payload_taken_ < payload_bytes_) break;
      if (!failed()) end_frame();
    } else if (wire.empty()) {
      break;
    } else {
      take_head_byte(static_cast<unsigned char>(wire.front()));
      wire.remove_prefix(1);
    }
  }
  return !failed();
}

void Layer::send(std::string_view text) {
  if (!closed_) append_frame(output_, kText, text);
}

void Layer::ping() {
  if (!closed_) append_frame(output_, kPing, {});
}

void Layer::end() {
  close(kNormal);
}

std::string Layer::take_output() {
  return std::exchange(output_, {});
}

void Layer::take_head_byte(unsigned char byte) {
  head_[head_bytes_++] = byte;
  // What shows early is said early: such a peer may never send the rest.
  if (head_bytes_ == 1 && !check_kind()) return;
  if (head_bytes_ == 2 && (byte & kMasked) == 0) {
    fail(kProtocolError, "a frame is not masked");
    return;
  }
  if (head_bytes_ + kMaskBytes == head_size() && !check_length()) return;
  if (head_bytes_ == head_size()) begin_frame();
}

/// The size of the frame's head, once its first two bytes are known.
std::size_t Layer::head_size() const {
  return 2 + length_bytes(head_[1] & kLength) + kMaskBytes;
}

bool Layer::check_kind() {
  const auto opcode = static_cast<unsigned char>(head_[0] & kOpcode);
  const bool control = opcode >= kClose;
  if ((head_[0] & kReserved) != 0) {
    fail(kProtocolError, "a frame uses an extension that was not agreed on");
  } else if (opcode == kBinary) {
    fail(kNotAcceptable, "a binary message came; only text is spoken here");
  } else if (opcode > kPong || (opcode > kBinary && !control)) {
    fail(kProtocolError, "a frame has an unknown opcode");
  } else if (control && (head_[0] & kFinal) == 0) {
    fail(kProtocolError, "a control frame is fragmented");
  } else if (opcode == kText && in_message_) {
    fail(kProtocolError, "a message begins within another");
  } else if (opcode == kContinuation && !in_message_) {
    fail(kProtocolError, "a fragment belongs to no message");
  }
  return !failed();
}

bool Layer::check_length() {
  const auto length = static_cast<unsigned char>(head_[1] & kLength);
  const std::size_t bytes = length_bytes(length);
  payload_bytes_ = bytes == 0 ? length : 0;
  for (std::size_t i = 0; i < bytes; ++i) payload_bytes_ = payload_bytes_ << 8U | head_[2 + i];
  const bool shortest = bytes == 0 || (bytes == 2 && payload_bytes_ >= kLength16) ||
                        (bytes == 8 && payload_bytes_ > 0xffff && payload_bytes_ >> 63U == 0);
  if (!shortest) {
    fail(kProtocolError, "a frame's length is not in its shortest form");
  } else if ((head_[0] & kOpcode) >= kClose && payload_bytes_ > kControlBytesMax) {
    fail(kProtocolError, "a control frame is longer than 125 bytes");
  } else if (payload_bytes_ > frame_bytes_max_) {
    fail(kTooBig, "a frame is longer than " + std::to_string(frame_bytes_max_) + " bytes");
  }
  return !failed();
}

void Layer::begin_frame() {
  in_payload_ = true;
  payload_taken_ = 0;
  control_.clear();
}

void Layer::take_payload(std::string_view& wire, std::string& text) {
  const bool control = (head_[0] & kOpcode) >= kClose;
  const std::size_t size = std::min<std::uint64_t>(wire.size(), payload_bytes_ - payload_taken_);
  const unsigned char* const mask = head_.data() + head_bytes_ - kMaskBytes;
  std::string& to = control ? control_ : text;
  const std::size_t before = to.size();
  to.append(wire.substr(0, size));
  for (std::size_t i = before; i < to.size(); ++i) {
    to[i] =
        static_cast<char>(static_cast<unsigned char>(to[i]) ^ mask[payload_taken_++ % kMaskBytes]);
  }
  wire.remove_prefix(size);
  if (control) return;
  const auto foreign = std::find_if(to.begin() + static_cast<std::ptrdiff_t>(before), to.end(),
                                    [](char c) { return static_cast<unsigned char>(c) > 0x7f; });
  if (foreign == to.end()) return;
  to.erase(foreign, to.end());
  fail(kNotText, "a text message holds a byte beyond ASCII");
}

void Layer::end_frame() {
  in_payload_ = false;
  head_bytes_ = 0;
  const auto opcode = static_cast<unsigned char>(head_[0] & kOpcode);
  if (opcode == kClose) {
    take_close();
  } else if (opcode == kPing) {
    append_frame(output_, kPong, control_);
  } else if (opcode != kPong) {
    in_message_ = (head_[0] & kFinal) == 0;
  }
}

void Layer::take_close() {
  ended_ = true;
  if (control_.empty()) {
    close(kNormal);
    return;
  }
  const auto byte = [this](std::size_t i) { return static_cast<unsigned char>(control_[i]); };
  const int code = control_.size() == 1 ? 0 : byte(0) << 8 | byte(1);
  if (is_close_code(code)) {
    close(code);
  } else {
    fail(kProtocolError, "a Close has no proper code");
  }
}

void Layer::close(int code) {
  if (std::exchange(closed_, true)) return;
  const char bytes[] = {static_cast<char>(code >> 8), static_cast<char>(code & 0xff)};
  append_frame(output_, kClose, {bytes, sizeof bytes});
}

void Layer::fail(int code, std::string reason) {
  reason_ = std::move(reason);
  close(code);
}

}  // namespace aucast::web
