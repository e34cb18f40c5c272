#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "common/result.h"

namespace aucast::gui {

/// What the window remembers until it is opened again.
struct KeptSettings {
  RemoteSettings remote;
  std::vector<std::string> recent;  ///< addresses, the newest first
  std::string face;                 ///< folder of the face to begin with; empty: the default face
  std::vector<std::string> recent_files;  ///< files that were played, the newest first
  std::string own_folder;          ///< where a file was saved or exported last; empty: none was
  std::vector<KnownTable> tables;  ///< how tables are read, the newest first
  AnimationSettings animation;
  TransitionSettings transition;
  RenderingSettings rendering;
  PictureSettings pictures;
  DisplaySettings display;
  int volume = 100;  ///< percent
  friend bool operator==(const KeptSettings&, const KeptSettings&) = default;
};

/// How many addresses are remembered.
inline constexpr std::size_t kRecentMax = 8;

/// The path $XDG_CONFIG_HOME/aucast/face-player.toml, else ~/.config/aucast/face-player.toml. The
/// arguments are the values of XDG_CONFIG_HOME and HOME, null if unset. A relative XDG_CONFIG_HOME
/// counts as unset, as its specification demands. Fails if both are unset.
[[nodiscard]] Result<std::filesystem::path> settings_file(const char* xdg_config_home,
                                                          const char* home);

struct ParsedSettings {
  KeptSettings settings;
  /// "file:line:column: ..." of what was left out: a value that is wrong, and the first unknown key
  /// of each table.
  std::vector<std::string> left_out;
};

/// Reads settings. What is missing or left out gets its default. BadData "file:line:column: ..." if
/// the text is not TOML.
[[nodiscard]] Result<ParsedSettings> parse_settings(std::string_view text, const std::string& file);
/// The settings as a commented TOML file, from which parse_settings() gets the same settings.
[[nodiscard]] std::string format_settings(const KeptSettings& settings);

/// Moves an address to the front of the list, or adds it there.
void remember_address(std::vector<std::string>& recent, const RemoteSettings& settings);

/// The same for a list of files.
void remember_file(std::vector<std::string>& recent, const std::string& file);

/// The result of load_settings().
struct LoadedSettings {
  KeptSettings settings;  ///< the defaults if there was no file, or it could not be read
  std::vector<std::string> left_out{};  ///< as ParsedSettings'
  std::string complaint;  ///< why the file's settings are not used, as a sentence for the user;
                          ///< empty: they are used, or there is no file
  bool may_write = true;  ///< false: writing would destroy a file that could neither be read nor
                          ///< renamed
};

/// Reads the settings. A file that can be read but is not TOML is renamed, so that it is not
/// overwritten: to FILE.broken or, if that exists, to the first of FILE.broken.2 to .5 that does
/// not. If all five exist, the file stays as it is; so does a file that cannot be read.
[[nodiscard]] LoadedSettings load_settings(const std::filesystem::path& file);
/// Writes the settings, completely or not at all. Makes the folder if it is missing.
[[nodiscard]] Result<void> save_settings(const KeptSettings& settings,
                                         const std::filesystem::path& file);

}  // namespace aucast::gui
