#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "client/app/player_options.h"
#include "client/gui/kept_settings.h"

namespace aucast::app {

/// The settings file of the window and the command line, which comes first.
class WindowSettings {
 public:
  /// Reads the file that the environment names; nothing for --no-config or without a window. What
  /// is wrong with it goes to the log and to complaint().
  [[nodiscard]] static WindowSettings load(const PlayerOptions& options);
  /// For tests: with this file; empty: none.
  WindowSettings(const PlayerOptions& options, std::filesystem::path file);

  /// The settings as the window begins with them.
  [[nodiscard]] const gui::KeptSettings& in_force() const { return in_force_; }
  /// The options as if those settings had been on the command line.
  [[nodiscard]] PlayerOptions applied(PlayerOptions options) const;
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

  /// Writes what the window has now, if that is another than the file has. What only the command
  /// line asked for is not kept.
  [[nodiscard]] Result<void> keep(gui::KeptSettings now);

 private:
  std::filesystem::path file_;  ///< empty: nothing is read or written
  gui::KeptSettings kept_;      ///< what the file has
  gui::KeptSettings in_force_;
  std::set<std::string> given_;
  std::string complaint_;
};

}  // namespace aucast::app
