#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "common/tls/channel.h"
#include "tests/support/raw_client.h"

namespace aucast::test {

/// A RawClient that speaks TLS. Only what the tests need: say, hear, end.
class TlsClient {
 public:
  TlsClient(const std::string& address, const tls::Context& context,
            const std::string& host = "localhost")
      : client_(address), channel_(context, host) {
    client_.send(channel_.take_output());
  }

  /// Goes on until the handshake is done or has failed. `first_words` go out in one piece with our
  /// last part of it: a hello is then there within any grace.
  bool shake_hands(std::string first_words = {}) {
    first_words_ = std::move(first_words);
    while (!channel_.ready() && step()) {
    }
    return channel_.ready();
  }
  void send(std::string_view plain) {
    channel_.send(plain);
    client_.send(channel_.take_output());
  }
  void end_sending() {
    channel_.end();
    client_.send(channel_.take_output());
    client_.end_sending();
  }
  /// Up to and with `text`; what came instead when the connection ends.
  std::string receive_until(std::string_view text) {
    while (received_.find(text) == std::string::npos && step()) {
    }
    const std::size_t found = received_.find(text);
    const std::size_t count = found == std::string::npos ? received_.size() : found + text.size();
    std::string taken = received_.substr(0, count);
    received_.erase(0, count);
    return taken;
  }
  std::string receive_all() {
    while (step()) {
    }
    return std::exchange(received_, {});
  }
  [[nodiscard]] const tls::Channel& channel() const { return channel_; }
  [[nodiscard]] RawClient& raw() { return client_; }

 private:
  bool step() {
    if (channel_.ended() || channel_.why() != tls::Channel::Why::None) return false;
    const std::string wire = client_.receive(1);
    if (wire.empty()) return false;
    channel_.received(wire, received_);
    if (channel_.ready()) channel_.send(std::exchange(first_words_, {}));
    if (const std::string answer = channel_.take_output(); !answer.empty()) client_.send(answer);
    return true;
  }

  RawClient client_;
  tls::Channel channel_;
  std::string first_words_;
  std::string received_;
};

}  // namespace aucast::test
