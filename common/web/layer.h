#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace aucast::web {

/// The server's side of one WebSocket (RFC 6455) without its socket: the bytes that arrive after
/// the upgrade are put in, and the bytes that are to be sent are taken out. Text messages are read
/// as one flow of ASCII bytes; where messages and fragments begin does not matter. Answers pings
/// and the peer's Close on its own. After a failure or a Close of either side nothing more goes in;
/// what take_output() still gives tells the peer why. Thread: none of its own.
class Layer {
 public:
  /// `frame_bytes_max`: the longest payload of a frame; a header that announces a longer one is a
  /// failure.
  explicit Layer(std::size_t frame_bytes_max) : frame_bytes_max_(frame_bytes_max) {}

  /// Takes bytes from the wire and appends the text that they carry to `text`. Returns false if the
  /// layer has failed.
  bool received(std::string_view wire, std::string& text);
  /// Sends one text message, ASCII only.
  void send(std::string_view text);
  /// Sends a Ping, which a peer that is still there answers with a Pong.
  void ping();
  /// Sends Close 1000; nothing can be sent after it.
  void end();
  /// Bytes for the wire.
  [[nodiscard]] std::string take_output();

  /// Whether the peer has sent its Close.
  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] bool failed() const { return !reason_.empty(); }
  /// A clause about the failure.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  void take_head_byte(unsigned char byte);
  [[nodiscard]] std::size_t head_size() const;
  void begin_frame();
  [[nodiscard]] bool check_kind();
  [[nodiscard]] bool check_length();
  void take_payload(std::string_view& wire, std::string& text);
  void end_frame();
  void take_close();
  void close(int code);
  void fail(int code, std::string reason);

  std::size_t frame_bytes_max_;
  std::array<unsigned char, 14> head_{};  ///< of the frame being read: at most 2 + 8 + 4 bytes
  std::size_t head_bytes_ = 0;
  bool in_payload_ = false;
  std::uint64_t payload_bytes_ = 0;  ///< of that frame
  std::uint64_t payload_taken_ = 0;  ///< how many of them were read
  std::string control_;              ///< payload of a control frame
  bool in_message_ = false;          ///< a text's last fragment is still to come
  bool closed_ = false;              ///< our Close is out
  bool ended_ = false;
  std::string output_;
  std::string reason_;
};

}  // namespace aucast::web
