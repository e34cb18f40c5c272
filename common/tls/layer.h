#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "common/tls/context.h"

struct ssl_st;

namespace aucast::tls {

/// The TLS of one connection without its socket: what comes over the wire goes in, what is to go
/// over the wire comes out. Thus the same code reads and writes with and without TLS. Uses no clock
/// except to check certificates; the owner decides how long a handshake may take. After a failure
/// nothing more goes in; what take_output() still gives tells the peer why. What the peer sends
/// after its close_notify is ignored, as RFC 8446 (6.1) wants. So a layer never holds more of what
/// came than one record that is not whole (16.6 KiB) and one message of the handshake (100 KiB).
/// Thread: none of its own.
class Layer {
 public:
  /// Why a layer failed, as far as its owner treats failures differently.
  enum class Why : std::uint8_t {
    None,
    NotTls,     ///< the peer's first bytes are not TLS
    Untrusted,  ///< a certificate is not trusted, by us or by the peer
    Broken,     ///< anything else
  };

  /// `host`: for clients, the name or address that the certificate must be for; not empty.
  explicit Layer(const Context& context, const std::string& host = {});
  ~Layer();
  Layer(Layer&&) noexcept;
  Layer& operator=(Layer&&) noexcept;

  /// Takes bytes from the wire and appends the decrypted ones to `plain`. Returns false if the
  /// layer has failed.
  bool received(std::string_view wire, std::string& plain);
  /// Call this only when ready().
  void send(std::string_view plain);
  /// Sends close_notify, which shows the peer that nothing was cut off.
  void end();
  /// Bytes for the wire.
  [[nodiscard]] std::string take_output();

  /// How many bytes that came from the wire wait for the rest of their record.
  [[nodiscard]] std::size_t held_bytes() const;
  /// Whether the handshake is done.
  [[nodiscard]] bool ready() const;
  /// Whether the peer has sent its close_notify.
  [[nodiscard]] bool ended() const;
  [[nodiscard]] Why why() const { return why_; }
  /// A sentence about the failure; text from the peer is escaped.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  struct Peer;
  struct Free {
    void operator()(ssl_st* ssl) const;
  };

  void shake_hands();
  void fail();
  [[nodiscard]] bool looks_like_tls(std::string_view wire) const;

  std::unique_ptr<Peer> peer_;
  std::unique_ptr<ssl_st, Free> ssl_;
  bool heard_ = false;  ///< whether any bytes have come
  bool ended_ = false;
  Why why_ = Why::None;
  std::string reason_;
};

}  // namespace aucast::tls
