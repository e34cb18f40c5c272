#pragma once

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

/// What the player's thread and the network thread share.
using SharedReader = Shared<AuReader>;

/// Carries out on a link what an AuReader decides; after a loss it goes on with the next link. The
/// owner makes the links, and waits before it makes the next one.
/// Thread: that of the links; the player's thread uses the reader too.
class ServerConnection final : public link::LinkUser {
 public:
  struct Hooks {
    std::function<void(Milliseconds wait)> dial;  ///< make a link after `wait`, then call begin()
                                                  ///< or fail()
  };
  struct Events {
    std::function<void()> over;     ///< the connection has ended for good
    std::function<void()> changed;  ///< there is something new for the player
  };

  /// `peer`: HOST:PORT, for messages.
  ServerConnection(SharedReader& reader, std::string peer, Hooks hooks, Events events);
  ~ServerConnection() override;
  ServerConnection(const ServerConnection&) = delete;
  ServerConnection& operator=(const ServerConnection&) = delete;

  void begin(std::shared_ptr<link::Link> link);
  /// No link could be made. `final`: another attempt would fail in the same way.
  void fail(const std::string& reason, bool final);
  /// Call when the player has done something after which the reader may have something to send.
  void speak(Instant now);
  /// The user leaves: sends the last bytes, then calls Events::over.
  void leave();

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
  const Hooks hooks_;
  const Events events_;
  std::shared_ptr<link::Link> link_;  ///< null: there is none
  bool open_ = false;
  bool link_over_ = false;   ///< the link has closed; bytes from it may still wait for room
  bool peer_ended_ = false;  ///< the peer has closed its side, and the reader does not know yet
  std::string broke_;        ///< why the connection broke; empty: the peer closed its side
  bool leaving_ = false;
  bool over_ = false;
};

}  // namespace aucast::net
