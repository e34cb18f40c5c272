#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "common/tls/layer.h"
#include "tests/support/raw_client.h"

namespace aucast::test {

/// A RawClient that speaks TLS. Only what the tests need: say, hear, end.
class TlsClient {
 public:
  TlsClient(const std::string& address, const tls::Context& context,
            const std::string& host = "localhost")
      : client_(address), layer_(context, host) {
    client_.send(layer_.take_output());
  }

  /// Runs the handshake until it is done or has failed. `first_words` are sent together with our
  /// last part of the handshake, so that a hello arrives within any grace. Returns whether the
  /// handshake is done.
  bool shake_hands(std::string first_words = {}) {
    first_words_ = std::move(first_words);
    while (!layer_.ready() && step()) {
    }
    return layer_.ready();
  }
  void send(std::string_view plain) {
    layer_.send(plain);
    client_.send(layer_.take_output());
  }
  void end_sending() {
    layer_.end();
    client_.send(layer_.take_output());
    client_.end_sending();
  }
  /// The next bytes up to the end of `text`. If the connection ends before, returns what has come.
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
  [[nodiscard]] const tls::Layer& layer() const { return layer_; }
  [[nodiscard]] RawClient& raw() { return client_; }

 private:
  bool step() {
    if (layer_.ended() || layer_.why() != tls::Layer::Why::None) return false;
    const std::string wire = client_.receive(1);
    if (wire.empty()) return false;
    layer_.received(wire, received_);
    if (layer_.ready()) layer_.send(std::exchange(first_words_, {}));
    if (const std::string answer = layer_.take_output(); !answer.empty()) client_.send(answer);
    return true;
  }

  RawClient client_;
  tls::Layer layer_;
  std::string first_words_;
  std::string received_;
};

}  // namespace aucast::test
