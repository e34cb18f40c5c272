#pragma once

#include <cstddef>
#include <optional>

#include "client/net/back_off.h"
#include "common/time.h"
#include "protocol/client_session.h"

namespace aucast::net {

/// Whether and when the AU Reader tries to connect again. Of several hosts each attempt goes to the
/// next one. Thread: none of its own.
class Retries {
 public:
  struct Options {
    bool reconnect = false;  ///< try again when the connection is lost or cannot be made
    bool one_round = false;  ///< until a server has been reached, each host is tried only once
    std::size_t hosts = 1;   ///< how many are tried in turn
  };
  /// Over which connections keyframes have come.
  struct Keyframes {
    bool earlier = false;  ///< over those that were lost
    bool now = false;      ///< over the latest one
  };

  explicit Retries(Options options) : options_(options) {}

  /// A hello has been answered.
  void granted() { granted_ = true; }
  /// Whether one ever was.
  [[nodiscard]] bool ever_granted() const { return granted_; }
  void keyframe_came() {
    back_off_.reset();
    busy_in_a_row_ = 0;
  }

  // How long to wait before the next attempt; nullopt: give up.

  /// No connection could be made.
  [[nodiscard]] std::optional<Milliseconds> unreachable(Keyframes came);
  /// A connection has failed. After a loss there is another attempt. If the server refuses us
  /// because it is full or has no such stream yet, there is one as long as one of the hosts has not
  /// said so; and if the stream was here before, always.
  [[nodiscard]] std::optional<Milliseconds> failed(const protocol::SessionFailed& event,
                                                   Keyframes came);

 private:
  [[nodiscard]] std::optional<Milliseconds> again(Keyframes came);

  Options options_;
  bool granted_ = false;
  std::size_t failures_ = 0;       ///< attempts that failed before a server was reached
  std::size_t busy_in_a_row_ = 0;  ///< how many hosts in a row were full or did not have the
                                   ///< stream yet
  BackOff back_off_;
};

}  // namespace aucast::net
