#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "client/playback/keyframe_buffers.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"
#include "protocol/client_session.h"

namespace aucast::net {

struct RemoteOptions {
  std::string host;
  std::uint16_t port = 4650;
  bool classic = false;     ///< --protocol classic
  std::string stream;       ///< --stream; empty: the first
  Duration connect_timeout = std::chrono::seconds(10);
  playback::BufferOptions buffers;
  /// Called on the network thread when something changed; may only unblock the player (mpv's
  /// wakeup). May be empty.
  std::function<void()> wakeup;
};

/// HOST, HOST:PORT, [V6]:PORT or [V6]. Usage error otherwise.
struct Endpoint {
  std::string host;
  std::uint16_t port = 4650;
};
[[nodiscard]] Result<Endpoint> parse_endpoint(std::string_view text);

/// The AU reader: a thread that connects, decodes, stores into the two buffers and answers. What
/// both threads touch is one guarded object (buffers and status); what the player asks of the network
/// thread is posted to it.
class RemoteSource final : public playback::KeyframeSource {
 public:
  explicit RemoteSource(RemoteOptions options);  ///< starts connecting at once
  ~RemoteSource() override;                      ///< stops, and joins the thread

  [[nodiscard]] std::optional<playback::TimedAus> take() override;
  [[nodiscard]] bool ready() const override;
  bool wait_until(Instant until) override;
  [[nodiscard]] playback::SourceStatus status() const override;
  void stop() override;

  /// The user pauses or resumes the transmission.
  void pause();
  void resume();

 private:
  struct Shared;
  class Reader;
  std::unique_ptr<Shared> shared_;
  std::unique_ptr<Reader> reader_;
};

}  // namespace aucast::net
