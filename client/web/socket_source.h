#pragma once

#include <memory>
#include <string>

#include "client/net/server_connection.h"
#include "client/playback/keyframe_source.h"
#include "client/web/timer.h"

namespace aucast::web {

/// The keyframes of the page's server: net::RemoteSource without a thread, over WebSockets.
/// Connects at once, and again when the connection is lost. Thread: the page's.
class SocketSource final : public playback::KeyframeSource {
 public:
  /// `voice`: the stream's voice is asked for. Its captions are always.
  SocketSource(std::string server, std::string stream, std::string token, bool voice);

  [[nodiscard]] std::optional<playback::TimedAus> take() override;
  [[nodiscard]] std::optional<playback::Voice> take_voice() override;
  [[nodiscard]] std::optional<playback::Caption> take_caption() override;
  [[nodiscard]] bool ready() const override;
  bool wait_until(Instant until) override;
  [[nodiscard]] playback::SourceStatus status() const override;
  void stop() override;
  void pause() override;
  void resume() override;

 private:
  void dial();
  void speak();

  mutable net::SharedReader reader_;
  Timer redial_;
  net::ServerConnection connection_;
};

}  // namespace aucast::web
