#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aucast::gui {

/// The form of the remote player, as people fill it in.
struct RemoteSettings {
  std::string address = "127.0.0.1";
  int port = 4650;
  int buffer = 100;
  int playout = 30;
  int threshold_percent = 40;
  int speed_ms = 0;        ///< 0: the server's own time
  bool reconnect = false;  ///< try again when the server is lost
  friend bool operator==(const RemoteSettings&, const RemoteSettings&) = default;
};

/// What is wrong with the form, as a sentence with the remedy; nothing when it can be used. The
/// limits are those of the command line.
[[nodiscard]] std::optional<std::string> problem(const RemoteSettings& settings);

/// HOST:PORT, or [V6]:PORT; the port is left out when it is the usual one.
[[nodiscard]] std::string endpoint_text(const RemoteSettings& settings);
/// The other way round, into address and port; false, changing nothing, for what is neither.
[[nodiscard]] bool take_endpoint(std::string_view text, RemoteSettings& settings);

}  // namespace aucast::gui
