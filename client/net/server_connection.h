#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "client/net/au_reader.h"
#include "common/link/link.h"
#include "common/shared.h"
#include "common/time.h"

namespace aucast::net {

/// The one object that the player's and the network thread both touch.
using SharedReader = Shared<AuReader>;

/// Carries out on links what an AuReader decides: one link after the other, when connections are
/// lost. The owner makes the links, and waits before the next one.
/// Thread: that of the links; the reader is shared with the player's.
class ServerConnection final : public link::LinkUser {
 public:
  /// What the connection asks of its owner.
  struct Owner {
    std::function<void(Milliseconds wait)> dial;  ///< a link, after `wait`: begin() or fail()
    std::function<void()> over;                   ///< nothing more will be wanted
    std::function<void()> changed;                ///< there is something new for the player
  };

  /// `peer`: HOST:PORT, for messages.
  ServerConnection(SharedReader& reader, std::string peer, Owner owner);
  ~ServerConnection() override;
  ServerConnection(const ServerConnection&) = delete;
  ServerConnection& operator=(const ServerConnection&) = delete;

  void begin(std::shared_ptr<link::Link> link);
  /// No link could be made. `final`: another attempt would fail in the same way.
  void fail(const std::string& reason, bool final);
  /// Call when the player has done something after which the reader may have something to send.
  void speak(Instant now);
  /// The user leaves: sends the last bytes, then calls over().
  void leave();

  /// Answers so far, as the protocol has them. Any thread.
  [[nodiscard]] std::uint64_t bytes_sent() const { return bytes_sent_; }

 private:
  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_time() override;
  void on_closed(const link::Ending& ending) override;

  void lose(std::string broke);
  void carry_out(const Reaction& reaction);
  void send(std::string_view words);
  void drop_link();

  SharedReader& reader_;
  const std::string peer_;
  const Owner owner_;
  std::shared_ptr<link::Link> link_;  ///< nothing: none is there
  bool open_ = false;
  bool link_over_ = false;   ///< it closed by itself; what it brought may still wait for room
  bool peer_ended_ = false;  ///< and the reader has not been told yet
  std::string broke_;        ///< why it did; empty: the peer shut its side
  bool leaving_ = false;
  bool over_ = false;
  std::atomic<std::uint64_t> bytes_sent_{0};
};

}  // namespace aucast::net
