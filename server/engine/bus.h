#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "common/result.h"

namespace aucast::server {

/// What an engine does for us: takes messages to whoever has subscribed to their subject.
/// Thread: that of the event loop, on which it tells its events too, never from within a call.
class Bus {
 public:
  struct Message {
    std::string subject;
    std::string reply_to;  ///< where an answer is to go; empty: none is wanted
    std::string bytes;
  };
  struct Events {
    std::function<void(Message)> on_message;
    /// Messages go now, over that server; again when another one has taken the place of a lost one.
    std::function<void(const std::string& server)> on_connected;
    std::function<void()> on_disconnected;
  };

  Bus() = default;
  virtual ~Bus() = default;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  virtual void subscribe(const std::string& subject) = 0;
  /// Lost when there is no connection: nothing is kept to be sent when it would be old.
  virtual void publish(const Message& message) = 0;
  /// A subject of our own, to which answers may go.
  [[nodiscard]] virtual std::string own_subject() const = 0;
  /// Messages that came faster than they were worked on, and had no room to wait.
  [[nodiscard]] virtual std::uint64_t left_out() const = 0;
};

using OpenBus = std::function<Result<std::unique_ptr<Bus>>(Bus::Events)>;

/// Where the batches of a stream go, and the questions of who joins.
[[nodiscard]] inline std::string batch_subject(const std::string& stream) {
  return "au." + stream + ".p";
}
[[nodiscard]] inline std::string join_subject(const std::string& stream) {
  return "au." + stream + ".join";
}

}  // namespace aucast::server
