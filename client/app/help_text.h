#pragma once

#include <string>
#include <string_view>

namespace aucast::app {

/// The page of --help for a command: "" (watching), play, pose, rules or
/// gallery. Fits one screen.
[[nodiscard]] std::string_view help_text(std::string_view command);

/// "face-player 0.1.0 ..." with protocol version and licence.
[[nodiscard]] std::string version_text();

}  // namespace aucast::app
