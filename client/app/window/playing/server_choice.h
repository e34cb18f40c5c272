#pragma once

#include <string>
#include <vector>

#include "client/app/player_options.h"
#include "client/gui/model/remote_settings.h"
#include "client/net/remote_source.h"
#include "common/result.h"

namespace aucast::app {

/// Which server the user wants: the form to fill in, how the server is reached, and which servers
/// have answered. `options` must outlive it. Thread: the player's.
class ServerChoice {
 public:
  explicit ServerChoice(const PlaybackOptions& options) : options_(options) {}
  explicit ServerChoice(PlaybackOptions&& options) = delete;  // a temporary would be gone

  /// Begins with what the window remembered.
  void set(const gui::RemoteSettings& settings, std::vector<std::string> recent);
  /// The options for connecting to the server that a form names. `voice`: whether there is a device
  /// for its voice. Fails if a file with a certificate or token cannot be used.
  [[nodiscard]] Result<net::RemoteOptions> server_of(const gui::RemoteSettings& settings,
                                                     bool voice) const;
  /// Call it when this server is dialled.
  void choose(const gui::RemoteSettings& settings) { settings_ = settings; }
  /// Call it when the chosen server has answered.
  void answered();

  [[nodiscard]] const gui::RemoteSettings& settings() const { return settings_; }
  /// The same, but with the last server that answered, so that a mistyped address is not kept.
  [[nodiscard]] gui::RemoteSettings to_keep() const {
    return gui::with_server_of(settings_, worked_);
  }
  /// Addresses that answered, the newest first.
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }

 private:
  const PlaybackOptions& options_;
  gui::RemoteSettings settings_;
  gui::RemoteSettings worked_;  ///< its server is the last that answered, or the remembered one
  std::vector<std::string> recent_;
};

}  // namespace aucast::app
