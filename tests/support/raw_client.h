#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace aucast::test {

/// How long a test waits for what must come: generous, so that a loaded machine fails nothing.
inline constexpr std::chrono::seconds kPatience{20};

/// A TCP client that says and hears bytes and knows nothing of the protocol. Blocking, for tests.
/// A connection that cannot be made or a send that fails leaves ok() false; nothing throws.
class RawClient {
 public:
  /// Connects to `address`, ADDR:PORT or [ADDR]:PORT as au-transmitter prints it.
  explicit RawClient(const std::string& address);
  ~RawClient();  ///< closes in the ordinary way
  RawClient(RawClient&& other) noexcept;
  RawClient& operator=(RawClient&&) = delete;
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  /// False once connecting or sending has failed.
  [[nodiscard]] bool ok() const { return ok_; }
  /// Our own port, by which the server names this client.
  [[nodiscard]] std::uint16_t local_port() const;

  /// Sends all bytes. Returns false when the peer does not take them in time or is gone.
  bool send(std::string_view bytes, std::chrono::milliseconds patience = kPatience);
  /// Half-close: nothing more is sent, but bytes can still be received.
  void end_sending();
  /// Closes with a reset instead of an end.
  void reset();

  /// Waits for the next `wanted` bytes, takes and returns them; fewer when the connection or the
  /// patience ends before.
  [[nodiscard]] std::string receive(std::size_t wanted,
                                    std::chrono::milliseconds patience = kPatience);
  /// Waits for the next `text`, takes and returns all bytes up to its end. If the connection or the
  /// patience ends before, returns what has come.
  [[nodiscard]] std::string receive_until(std::string_view text,
                                          std::chrono::milliseconds patience = kPatience);
  /// Receives everything to the end of the connection.
  [[nodiscard]] std::string receive_all(std::chrono::milliseconds patience = kPatience);
  /// Receives and drops everything; true when the connection ended in time, however it did.
  [[nodiscard]] bool wait_for_end(std::chrono::milliseconds patience = kPatience);
  /// Whether all that has come was taken, and nothing more comes for `time`.
  [[nodiscard]] bool silent(std::chrono::milliseconds time);
  /// Whether the peer has ended or broken the connection, as far as was received.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Whether it ended by a reset or another error, not in order.
  [[nodiscard]] bool broken() const { return broken_; }

 private:
  bool receive_some(std::chrono::steady_clock::time_point until);
  [[nodiscard]] std::string take(std::size_t count);

  int socket_ = -1;
  bool ok_ = false;
  bool ended_ = false;
  bool broken_ = false;
  std::string received_;
};

}  // namespace aucast::test
