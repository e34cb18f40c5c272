#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <asio/io_context.hpp>

#include "common/link/link.h"
#include "common/time.h"
#include "protocol/server_session.h"
#include "server/push/introduction.h"
#include "server/status/stats.h"
#include "server/status/status.h"
#include "server/upstream/dialled_address.h"
#include "server/upstream/redialler.h"

namespace aucast::server {

/// Sends a stream of this server to another one (--push): dials that server, offers the stream and,
/// when it is taken, serves the connection like any client's. When the connection is lost or the
/// stream is refused, it tries again, without end. A recorded stream that was sent whole is offered
/// again every kOfferAgain, since a server that was restarted has forgotten it; a live one that has
/// ended is offered again as soon as it goes on.
/// Thread: that of the io_context, which must outlive it.
class Pusher {
 public:
  using OnServed = std::function<void(const ClientRecord&, const std::string& why)>;
  /// `name`: the stream's name in the address; empty: the first stream.
  struct Hooks {
    /// The stream to offer, as it is now; null: there is none.
    std::function<const protocol::ServedStream*(const std::string& name)> stream;
    /// Serves the stream on the open link, on which these bytes have come; calls OnServed at the
    /// end.
    std::function<void(const std::string& name, std::string peer, std::shared_ptr<link::Link>,
                       std::string_view bytes, OnServed)>
        serve;
  };

  /// `held_back_max`: in bytes, see link::tcp_link().
  Pusher(asio::io_context& io, DialledAddress to, int held_back_max, Hooks hooks);
  ~Pusher() { stop(); }
  Pusher(const Pusher&) = delete;
  Pusher& operator=(const Pusher&) = delete;

  void start() { redialler_.dial(); }
  /// Dials no more. A stream that is being sent goes on.
  void stop();

  [[nodiscard]] PushStatus status() const;

 private:
  [[nodiscard]] const protocol::ServedStream* stream() const;
  [[nodiscard]] bool ready() const;
  [[nodiscard]] std::string name() const;  ///< for the log
  [[nodiscard]] std::string stream_name() const;
  /// For the log, if no stream has the name that was asked for: that the first one is sent. Or "".
  [[nodiscard]] std::string substitute() const;
  void introduce(std::shared_ptr<link::Link> link);
  void on_answer(const protocol::PublishSession::Answer& answer);
  void on_served(const ClientRecord& record, const std::string& why);

  DialledAddress to_;
  /// Tells the other server that a Pusher which comes back is the same one. Not the ID of this
  /// server: two of its Pushers with one stream name would replace each other for ever.
  const std::string id_;
  Hooks hooks_;
  Redialler redialler_;
  std::unique_ptr<Introduction> introduction_;  ///< while the answer is awaited; else null
  bool serving_ = false;
  bool said_ = false;  ///< whether the log has said that it was taken
  std::uint64_t connects_ = 0;
  std::uint64_t losses_ = 0;
};

}  // namespace aucast::server
