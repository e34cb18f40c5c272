#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/link/link.h"
#include "common/time.h"
#include "protocol/client_session.h"
#include "server/upstream/relayed_stream.h"

namespace aucast::server {

/// One connection to a parent or from a publisher: the level-2 client that fills a RelayedStream.
/// It answers every keyframe at once, since it always has room. It leaves a parent that breaks the
/// protocol, or whose stream does not continue the one that is here.
/// Thread: that of the link.
class Parent final : public link::LinkUser {
 public:
  struct Outcome {
    bool in_order = false;  ///< {-2} came: the parent has no more
    std::string reason;     ///< a clause for the log
    bool unfit = false;     ///< its stream does not continue the one that is here
  };
  struct Events {
    std::function<void()> on_moved_on;  ///< the stream has something new
    /// Nothing more comes from this parent, which this call may destroy.
    std::function<void(const Outcome&)> on_over;
  };
  struct Greeting {
    std::string token;   ///< empty: none
    std::string id;      ///< of this relay
    bool takes = false;  ///< the peer is a publisher, whose stream we take
  };

  /// `stream` must outlive it.
  Parent(std::shared_ptr<link::Link> link, RelayedStream& stream, const Greeting& greeting,
         Events events);
  ~Parent() override;
  Parent(const Parent&) = delete;
  Parent& operator=(const Parent&) = delete;

  void start() { link_->start(*this); }
  /// Instead of start(), for a link that is already open.
  void take_over();

  [[nodiscard]] std::uint64_t keyframes() const { return session_.keyframes_received(); }
  [[nodiscard]] std::uint64_t bytes() const { return session_.payload_bytes(); }

 private:
  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_time() override;
  void on_closed(const link::Ending& ending) override;

  void carry_out(const std::vector<protocol::ClientEvent>& events);
  void handle(const protocol::SendBytes& event);
  void handle(const protocol::DeliverKeyframe& event);
  void handle(const protocol::DeliverVoice& event);
  void handle(const protocol::DeliverCaption& event);
  void handle(const protocol::Granted& event);
  void handle(const protocol::StreamEnded& event);
  void handle(const protocol::ReconnectClassic& event);
  void handle(const protocol::SessionFailed& event);
  void leave(std::optional<std::string> wrong);
  [[nodiscard]] bool floods();
  void settle();

  std::shared_ptr<link::Link> link_;
  RelayedStream& stream_;
  Events events_;
  protocol::ClientSession session_;
  std::string packet_;  ///< the bytes read since the last whole packet
  std::string answers_;
  bool moved_on_ = false;  ///< whether the running call changed the stream
  std::optional<Outcome> outcome_;
  Instant second_begin_{};
  std::uint32_t in_second_ = 0;
};

}  // namespace aucast::server
