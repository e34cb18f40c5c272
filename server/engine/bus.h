#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "common/result.h"

namespace aucast::server {

/// A connection to an engine, which carries messages to all subscribers of their subject.
/// Thread: that of the event loop. Events are called there too, but never from within a function of
/// the Bus.
class Bus {
 public:
  struct Message {
    std::string subject;
    std::string reply_to;  ///< the subject for an answer; empty: none is wanted
    std::string bytes;
  };
  struct Events {
    std::function<void(Message)> on_message;
    /// Messages can be sent from now on, over this server. Called again after on_disconnected(),
    /// perhaps with another server.
    std::function<void(const std::string& server)> on_connected;
    std::function<void()> on_disconnected;
  };

  Bus() = default;
  virtual ~Bus() = default;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// Subscribes for as long as the Bus lives, through all reconnects. If this fails, it is logged,
  /// and tried again after a pause over another connection. If a server forbids it, the server's
  /// reply is logged, and it is tried again on every reconnect.
  virtual void subscribe(const std::string& subject) = 0;
  /// Sends a message. Without a connection it is lost: nothing is kept to be sent later.
  virtual void send(const Message& message) = 0;
  /// A subject of our own, to which answers may go.
  [[nodiscard]] virtual std::string own_subject() const = 0;
  /// How many messages were dropped because they came faster than they were handled.
  [[nodiscard]] virtual std::uint64_t left_out() const = 0;
};

using OpenBus = std::function<Result<std::unique_ptr<Bus>>(Bus::Events)>;

/// The subjects of a stream: one for its batches, and one for requests (protocol::EngineJoin).
[[nodiscard]] inline std::string batch_subject(const std::string& stream) {
  return "au." + stream + ".p";
}
[[nodiscard]] inline std::string join_subject(const std::string& stream) {
  return "au." + stream + ".join";
}

}  // namespace aucast::server
