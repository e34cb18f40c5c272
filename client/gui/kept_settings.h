#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "client/gui/gui_model.h"
#include "common/result.h"

namespace aucast::gui {

/// What the window remembers from one time to the next.
struct KeptSettings {
  RemoteSettings remote;
  std::vector<std::string> recent;  ///< addresses, the last one first
  std::string face;  ///< the folder of the face to begin with; empty: the one that is shipped
  std::vector<std::string> recent_files;  ///< that were played, the last one first
  std::vector<KnownTable> tables;         ///< how they are read, the last one first
  AnimationSettings animation;
  TransitionSettings transition;
  RenderingSettings rendering;
  PictureSettings pictures;
  DisplaySettings display;
  friend bool operator==(const KeptSettings&, const KeptSettings&) = default;
};

/// How many addresses are remembered.
inline constexpr std::size_t kRecentMax = 8;

/// $XDG_CONFIG_HOME/aucast/face-player.toml, or the same in ~/.config; the arguments are the values
/// of XDG_CONFIG_HOME and HOME, null when unset. A relative XDG_CONFIG_HOME counts as unset, as its
/// specification wants. Failed when there is neither.
[[nodiscard]] Result<std::filesystem::path> settings_file(const char* xdg_config_home,
                                                          const char* home);

/// BadData "file:line:column: ..." for the first thing that is wrong. What is not said keeps its
/// usual value.
[[nodiscard]] Result<KeptSettings> parse_settings(std::string_view text, const std::string& file);
/// A TOML file for people; parse_settings() gives the same settings back.
[[nodiscard]] std::string format_settings(const KeptSettings& settings);

/// Puts an address in front of the list, without doubling it.
void remember_address(std::vector<std::string>& recent, const RemoteSettings& settings);

/// The same for a list of files.
void remember_file(std::vector<std::string>& recent, const std::string& file);

/// What a file held, or that it had to be put aside.
struct LoadedSettings {
  KeptSettings settings;  ///< the usual ones when there was no file, or no good one
  std::string complaint;  ///< a sentence for the user; empty when all is well
  bool may_write = true;  ///< false: writing would destroy what could neither be read nor kept
};

/// Reads the settings. A file that is wrong is renamed to FILE.broken (the last one stays), so that
/// it is never overwritten; one that cannot be read stays as it is.
[[nodiscard]] LoadedSettings load_settings(const std::filesystem::path& file);
/// Writes them whole or not at all, and makes the folder when it is missing.
[[nodiscard]] Result<void> save_settings(const KeptSettings& settings,
                                         const std::filesystem::path& file);

}  // namespace aucast::gui
