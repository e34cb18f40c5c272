#pragma once

#include <string>
#include <vector>

#include "client/app/player_options.h"
#include "client/gui/remote_settings.h"
#include "client/net/remote_source.h"
#include "common/result.h"

namespace aucast::app {

/// Which server the user wants: the form to fill in, how that one is reached, and which ones
/// have answered. `options` must outlive it. Thread: the player's.
class ServerChoice {
 public:
  explicit ServerChoice(const PlaybackOptions& options) : options_(options) {}

  /// Begins with what the window remembered.
  void set(const gui::RemoteSettings& settings, std::vector<std::string> recent);
  /// How to reach the server that a form names; `voice`: there is a device to hear its voice by.
  /// Error when a file of certificate or token cannot be used.
  [[nodiscard]] Result<net::RemoteOptions> server_of(const gui::RemoteSettings& settings,
                                                     bool voice) const;
  /// This one is dialled.
  void choose(const gui::RemoteSettings& settings) { settings_ = settings; }
  /// The one that was chosen has answered.
  void answered();

  [[nodiscard]] const gui::RemoteSettings& settings() const { return settings_; }
  /// The same, with the last server that answered: one that was mistyped is not worth keeping.
  [[nodiscard]] gui::RemoteSettings to_keep() const {
    return gui::with_server_of(settings_, worked_);
  }
  /// Addresses that answered, the latest first.
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }

 private:
  const PlaybackOptions& options_;
  gui::RemoteSettings settings_;
  gui::RemoteSettings worked_;  ///< its server is the last that answered, or was kept
  std::vector<std::string> recent_;
};

}  // namespace aucast::app
