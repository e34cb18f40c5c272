#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "client/face/muscle_mixer.h"
#include "client/glb/basis.h"
#include "client/gui/model/display_settings.h"
#include "client/gui/model/table_settings.h"
#include "client/mirror/mirror_options.h"
#include "client/net/security.h"
#include "client/net/stream_request.h"
#include "client/playback/blinking.h"
#include "client/playback/interpolator.h"
#include "client/playback/source_playback.h"
#include "client/view/style.h"
#include "client/view/viewpoint.h"
#include "common/result.h"
#include "common/time.h"
#include "protocol/endpoint.h"

namespace aucast::app {

enum class Command : std::uint8_t {
  Watch,    ///< [HOST[:PORT]]: in the window, or with --headless
  Play,     ///< play FILE
  Pose,     ///< pose [AUS]
  Rules,    ///< rules AUS
  Gallery,  ///< gallery DIR
  Export,   ///< export [STREAM] FILE.glb
  Help,     ///< print `text` and exit
};

/// What a face is made of and how AUs become a face, for all commands.
struct FaceOptions {
  std::filesystem::path data;    ///< --data; empty: find_data_folder() decides
  std::string face = "default";  ///< --face: a folder, or a name in data/faces
  std::string rules = "facs";    ///< --rules: facs, kumar2010, none or a file
  face::Mixer mixer = face::Mixer::Maximum;
};

/// How keyframes are received and played; `voice`: it is heard or written.
struct PlaybackOptions : net::StreamRequest {
  std::string endpoint;                    ///< HOST[:PORT]; empty: none
  std::vector<protocol::Endpoint> others;  ///< the further hosts of an address that names several
  std::filesystem::path file;              ///< play FILE
  playback::Interpolation interpolation = playback::Interpolation::Linear;
  Duration connect_timeout = std::chrono::seconds(10);
  Milliseconds hold = playback::SourcePlayback::kHold;  ///< --hold: the stall after which the face
                                                        ///< eases to neutral
  net::SecurityOptions security;                ///< TLS with its files, and the token's file
  std::optional<playback::BlinkOptions> blink;  ///< --blink or --idle; nullopt: no blinking
  std::optional<std::uint64_t> idle_seed;       ///< --idle; nullopt: no saccades and no breath
};

/// Where pictures and numbers go.
struct OutputOptions {
  std::filesystem::path frames;             ///< --frames DIR
  std::filesystem::path record;             ///< --record FILE
  std::filesystem::path sheet;              ///< --sheet FILE.png
  std::filesystem::path stats;              ///< --stats FILE.json
  std::filesystem::path onsets;             ///< --onsets FILE.csv
  std::optional<int> fps;                   ///< 1-240
  std::optional<std::uint32_t> background;  ///< --background RRGGBB; nullopt: the default
  bool transparent = false;                 ///< --background none
  int width = 800;
  int height = 600;
  view::Layers layers;      ///< --show
  bool size_given = false;  ///< --size was given; if not, the window chooses its own size
  bool fast = false;

  /// Whether pictures of all times are drawn, not only of the keyframes.
  [[nodiscard]] bool film() const { return !frames.empty() || !record.empty(); }
  [[nodiscard]] bool pictures() const { return film() || !sheet.empty(); }
};

/// Options about sound.
struct SoundOptions {
  int volume = 100;  ///< percent
  bool mute = false;
  bool none = false;                  ///< --no-sound
  std::filesystem::path file;         ///< --sound FILE.wav
  std::optional<std::string> device;  ///< --sound-device; "default" is the system's
};

/// Whether sound is written: to the file of --sound or into a video.
[[nodiscard]] bool wants_video_sound(const SoundOptions& sound, const OutputOptions& output);

struct PoseOptions {
  std::string aus;  ///< for pose and rules; written as in a packet
  std::vector<std::pair<std::string, float>> muscles;  ///< --muscle NAME=VALUE, in order
  std::string expression;
  std::filesystem::path png;
  std::filesystem::path obj;
  view::ViewpointPreset viewpoint = view::ViewpointPreset::Front;  ///< --camera
  bool list = false;     ///< --list: print the names that can be given
  bool explain = false;  ///< rules --explain
};

/// What `gallery` makes. Viewpoint, size, mixer and rules are in the other structs.
struct GalleryOptions {
  std::filesystem::path folder;     ///< gallery DIR
  std::vector<std::string> only;    ///< --only: names of sections; empty: all
  std::vector<std::string> sweeps;  ///< --sweep: AUs, names of expressions, or all
};

/// What `export` writes. Face, fps and what moves the face are in the other structs.
struct ExportOptions {
  std::vector<std::filesystem::path> files;  ///< the stream file, if there is one, then the GLB
                                             ///< file
  glb::Basis basis = glb::Basis::Muscles;

  [[nodiscard]] const std::filesystem::path& glb() const { return files.back(); }
  /// The stream file; empty: the face alone.
  [[nodiscard]] std::filesystem::path stream() const {
    return files.size() > 1 ? files.front() : std::filesystem::path();
  }
};

struct PlayerOptions {
  Command command = Command::Watch;
  FaceOptions face;
  PlaybackOptions playback;
  OutputOptions output;
  SoundOptions sound;
  PoseOptions pose;
  GalleryOptions gallery;
  ExportOptions exported;
  gui::TableSettings table;      ///< --table-...: how the table of play and export is read
  gui::DisplaySettings display;  ///< --language, --text-size
  bool shows_mirror = false;     ///< --mirror: the window begins with the user's own camera
  mirror::MirrorOptions mirror;  ///< which camera, and how others may see it
  bool headless = false;
  /// Whether the voice is to be asked for, because it is heard or written.
  [[nodiscard]] bool wants_voice() const;
  bool list = false;  ///< --list: print the names of the server's streams
  bool exit_at_end = false;
  bool quiet = false;
  bool config = true;           ///< --no-config: the window neither reads nor writes its settings
  std::set<std::string> given;  ///< the options on the command line, such as "--buffer"
  std::string log_level = "warning";
  std::string text;  ///< Help: what to print
};

/// Reads the command line, without the program's name. Fails with a usage error of one line.
[[nodiscard]] Result<PlayerOptions> parse_player_options(std::vector<std::string> arguments);

/// "face-player 0.2.0 ..." with protocol version and licence.
[[nodiscard]] std::string version_text();

/// The manual page face-player(1) in roff.
[[nodiscard]] std::string manual_page();

/// If the arguments are --help-completion [bash|zsh|fish], returns the script by which that shell
/// completes face-player's options and commands; else nullopt.
[[nodiscard]] std::optional<std::string> completion(const std::vector<std::string>& arguments);

}  // namespace aucast::app
