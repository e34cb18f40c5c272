#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/net/connected_source.h"
#include "client/net/security.h"
#include "client/net/stream_request.h"
#include "common/result.h"
#include "common/time.h"
#include "protocol/endpoint.h"
#include "protocol/limits.h"

namespace aucast::net {

using protocol::Endpoint;
using protocol::parse_endpoint;

struct RemoteOptions : StreamRequest {
  std::string host;
  std::uint16_t port = protocol::kDefaultPort;
  std::vector<Endpoint> others{};  ///< with `reconnect`: other servers of the stream, tried in turn
  /// How long it may take to look up and reach the server. Its first packet may then take as long
  /// again.
  Duration connect_timeout = std::chrono::seconds(10);
  Security security{};
  /// Called on the network thread when something has changed, until the source is destroyed. It may
  /// only wake the player. May be empty.
  std::function<void()> wakeup;
};

/// The keyframes of a server. A thread of its own, the network thread, dials and runs a
/// ServerConnection. The network thread and the player's share the AuReader, behind a lock; what
/// the player asks of the network thread is posted to it. A failure shows in status(): Unreachable,
/// ConnectionLost, ProtocolError or Refused, with a sentence for the user. Keyframes received
/// before are still returned.
class RemoteSource final : public ConnectedSource {
 public:
  explicit RemoteSource(RemoteOptions options);  ///< starts connecting at once
  /// Stops as stop() does and joins the thread; sending the last bytes may take kFarewellTimeMax.
  ~RemoteSource() override;

  bool wait_until(Instant until) override;

 private:
  class Network;

  void speak() override;
  void leave() override;

  std::unique_ptr<Network> network_;  ///< null: the system lacked the resources for it
};

}  // namespace aucast::net
