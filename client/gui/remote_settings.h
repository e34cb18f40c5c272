#pragma once

#include <optional>
#include <string>

namespace aucast::gui {

/// The form of the remote player, as people fill it in.
struct RemoteSettings {
  std::string address = "127.0.0.1";
  int port = 4650;
  int buffer = 100;
  int playout = 30;
  int threshold_percent = 40;
  int speed_ms = 0;  ///< 0: the server's own time
  friend bool operator==(const RemoteSettings&, const RemoteSettings&) = default;
};

/// What is wrong with the form, as a sentence with the remedy; nothing when it can be used. The
/// limits are the contract's.
[[nodiscard]] std::optional<std::string> problem(const RemoteSettings& settings);

}  // namespace aucast::gui
