#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "client/app/player_options.h"
#include "client/gui/storage/kept_settings.h"

namespace aucast::app {

/// Combines the window's settings file with the command line, which takes precedence.
class WindowSettings {
 public:
  /// Reads the file that the environment names, unless there is --no-config or no window. Logs
  /// errors in the file and keeps them in complaint().
  [[nodiscard]] static WindowSettings load(const PlayerOptions& options);
  /// For tests: uses this file; empty: none.
  WindowSettings(const PlayerOptions& options, std::filesystem::path file);

  /// The settings with which the window begins.
  [[nodiscard]] const gui::KeptSettings& in_force() const { return in_force_; }
  /// `options` as if those settings had been on the command line.
  [[nodiscard]] PlayerOptions applied(PlayerOptions options) const;
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

  /// Writes the window's present settings if they differ from the file's. Settings that only the
  /// command line asked for are not written.
  [[nodiscard]] Result<void> keep(gui::KeptSettings now);

 private:
  std::filesystem::path file_;  ///< empty: nothing is read or written
  gui::KeptSettings kept_;      ///< the settings in the file
  gui::KeptSettings in_force_;
  std::set<std::string> given_;
  std::string complaint_;
  std::vector<std::string> left_out_;  ///< of the file
};

}  // namespace aucast::app
