#pragma once

#include <string>

#include "client/net/connected_source.h"
#include "client/web/timer.h"

namespace aucast::web {

/// The keyframes of the page's server: like net::RemoteSource, but over WebSockets and without a
/// thread. Connects at once, and again when the connection is lost. Thread: the page's.
class SocketSource final : public net::ConnectedSource {
 public:
  /// `voice`: whether to ask for the stream's voice. Captions are always asked for.
  SocketSource(std::string server, std::string stream, std::string token, bool voice);

  bool wait_until(Instant until) override;

 private:
  void dial();
  void speak() override;
  void leave() override;

  Timer redial_;
  net::ServerConnection connection_;
};

}  // namespace aucast::web
