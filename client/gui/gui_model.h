#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/muscle_mixer.h"
#include "client/gui/composer_view.h"
#include "client/gui/display_settings.h"
#include "client/gui/file_browser.h"
#include "client/gui/gallery_view.h"
#include "client/gui/mirror_view.h"
#include "client/gui/picture_settings.h"
#include "client/gui/remote_settings.h"
#include "client/gui/stream_view.h"
#include "client/gui/table_settings.h"
#include "client/playback/blinking.h"
#include "client/playback/interpolator.h"
#include "client/view/style.h"
#include "protocol/packet.h"

namespace aucast::gui {

// What the panels show: plain data, made anew for every frame. A panel is a function from this to
// the commands of gui_commands.h and keeps nothing but what belongs to the widgets themselves.

/// Whether something plays, and what may be asked for now.
enum class Activity : std::uint8_t {
  Idle,        ///< nothing was ever opened
  Connecting,  ///< the server has not answered yet
  Playing,     ///< also buffering and stalled
  Paused,
  Over,  ///< ended, stopped or lost: the last face stays
};

/// One buffer as a bar.
struct BufferBar {
  std::size_t fill = 0;
  std::size_t capacity = 1;
  int threshold_percent = 0;  ///< where the mark stands; 0: no mark
  friend bool operator==(const BufferBar&, const BufferBar&) = default;
};

/// One AU: as the keyframe under way has it, and as the face shows it at this moment.
struct AuRow {
  std::string label;         ///< "12", "L14"
  std::string name;          ///< FACS name; empty for a number without one
  int received_percent = 0;  ///< 0: not received; a rule made it, or it is going away
  int shown_percent = 0;     ///< 0: a rule took it away, or it has not begun to show
  std::string why;           ///< the rule that changed it; empty when none did
  friend bool operator==(const AuRow&, const AuRow&) = default;
};

/// How strong one AU was over the last half minute.
struct AuTrace {
  int number = 0;
  std::vector<float> values;  ///< in [0,1], oldest first
  friend bool operator==(const AuTrace&, const AuTrace&) = default;
};
/// More lines than this nobody can tell apart.
inline constexpr std::size_t kTracesMax = 6;

/// What plays: the stream of a server, or a stream file.
struct PlayingView {
  Activity activity = Activity::Idle;
  std::string state;         ///< in words: "buffering 42 %"
  std::string detail;        ///< why it ended, a sentence; empty unless it went wrong
  bool tries_again = false;  ///< the server was lost
  int again_s = 0;           ///< seconds until then; 0: now
  std::string stream;        ///< what a server plays, as it says; empty: nothing, or it does not
  std::string ended_by;      ///< the server that has ended the stream: "host:port"; empty: none has
  bool stale = false;        ///< the face shown is the last of a lost connection
  bool eased = false;        ///< nothing came for long: the face has gone to neutral
  bool timed = false;        ///< keyframes come with times of their own: the speed does nothing
  bool local = false;        ///< a stream file: no buffers, no bytes
  std::optional<bool> live{};  ///< the stream of a server, as far as it has said so
  BufferBar receiver;
  BufferBar playout;
  std::vector<float> receiver_history;  ///< fill in [0,1] over the last half minute, oldest first
  std::vector<AuTrace> au_history;      ///< the strongest AUs over the same time
  std::string in;                       ///< "6 packets, 93 B, 0.4 kbit/s"; empty: none yet
  std::string out;                      ///< "12 B, 0.1 kbit/s"
  std::string protocol;                 ///< "level 2", "classic"
  std::string delay;                    ///< "42 ms (at most 57, wanted 41)"; empty: not live
  std::string keyframe;                 ///< "keyframe 3"; empty before the first
  std::vector<AuRow> aus;
  friend bool operator==(const PlayingView&, const PlayingView&) = default;
};

/// How AUs become a face; may change while it plays.
struct AnimationSettings {
  face::Mixer mixer = face::Mixer::Maximum;
  std::string rules = "facs";  ///< what --rules takes
  playback::Interpolation interpolation = playback::Interpolation::Linear;
  friend bool operator==(const AnimationSettings&, const AnimationSettings&) = default;
};

/// A line of the expression editor: one channel, or a left and a right one under one name.
struct ChannelRow {
  std::string name;  ///< for people: "zygomaticus major"
  float maximum = 2;
  int left = -1;  ///< the channel's index; a central one stands here; -1: there is none
  int right = -1;
  float left_value = 0;
  float right_value = 0;
  friend bool operator==(const ChannelRow&, const ChannelRow&) = default;
};

struct ChannelGroup {
  std::string_view name;
  std::vector<ChannelRow> rows;
  friend bool operator==(const ChannelGroup&, const ChannelGroup&) = default;
};

struct EditorView {
  bool active = false;  ///< the face shows what the editor says
  std::vector<ChannelGroup> groups;
  bool linked = true;
  int au = -1;  ///< the AU being edited; -1: none
  bool unsaved = false;
  std::map<int, std::string> names;  ///< of AUs, typed and not saved yet
  bool can_undo = false;
  bool can_redo = false;
  std::vector<AuRow> compound;  ///< the AUs that were last put together; empty: none
  friend bool operator==(const EditorView&, const EditorView&) = default;
};

/// An AU as the list of the editor has it.
struct AuEntry {
  int number = 0;
  std::string name;     ///< FACS name
  std::string muscles;  ///< what it drives: "zygomaticus major 0.8, lip corner 1"
  std::string looks;    ///< what a face with it looks like; empty: nothing is known
  bool own = false;     ///< one's own: the player came without it, or with another one
  bool shipped = true;  ///< the player came with one
  friend bool operator==(const AuEntry&, const AuEntry&) = default;
};

enum class ExpressionKind : std::uint8_t {
  Main,   ///< the first set of AUs under its label: a button
  Macro,  ///< muscles, as Waters' program has its expressions: a button
  Other,  ///< another set of AUs under the same label: in a list
};

/// An expression as a button.
struct ExpressionButton {
  std::string label;
  std::string aus;  ///< as in a packet; "0" for muscles alone
  ExpressionKind kind = ExpressionKind::Main;
  std::string source{};  ///< who describes it so, in words
  friend bool operator==(const ExpressionButton&, const ExpressionButton&) = default;
};

/// The named expressions, and the one that the face shows.
struct ExpressionsView {
  std::vector<ExpressionButton> buttons;
  int chosen = -1;    ///< index of the one that is shown; -1: none, or it was changed since
  int percent = 100;  ///< 0-100: how much of an expression is shown
  std::string aus;    ///< of the chosen one at this strength, as in a packet; empty: none
  friend bool operator==(const ExpressionsView&, const ExpressionsView&) = default;
};

/// How an expression is reached from the face as it is.
struct TransitionSettings {
  static constexpr int kFramesMax = 500;
  static constexpr int kFrameMsMax = 1000;

  int frames = 50;   ///< in between, 1 to kFramesMax
  int frame_ms = 5;  ///< 1 to kFrameMsMax
  bool cosine = false;
  friend bool operator==(const TransitionSettings&, const TransitionSettings&) = default;
};

/// None: pictures are transparent there; the window shows a chequer.
enum class Ground : std::uint8_t { Studio, Black, Grey, White, None };
enum class Facing : std::uint8_t { Front, ThreeQuarter, Profile };

/// To either side, and up and down.
inline constexpr int kLightYawMaxDeg = 180;
inline constexpr int kLightPitchMaxDeg = 80;
inline constexpr int kLightPercentMax = 200;
/// Of a random seed, which may be larger.
inline constexpr int kSeedShownMax = 999'999;
[[nodiscard]] constexpr int shown_seed(std::uint64_t seed) {
  return seed < kSeedShownMax ? static_cast<int>(seed) : kSeedShownMax;
}

struct RenderingSettings {
  view::Layers layers;
  Ground ground = Ground::Studio;
  int light_yaw_deg = -31;   ///< of the key light, to the subject's left; up to kLightYawMaxDeg
  int light_pitch_deg = 32;  ///< up; up to kLightPitchMaxDeg
  int light_percent = 100;   ///< 0 to kLightPercentMax
  bool blinking = false;
  playback::BlinkOptions blink;
  friend bool operator==(const RenderingSettings&, const RenderingSettings&) = default;
};

/// A figure of the speed of drawing: "pictures a second", "24".
struct PaceRow {
  std::string name;
  std::string value;
  friend bool operator==(const PaceRow&, const PaceRow&) = default;
};

struct RenderingView {
  RenderingSettings settings;
  std::vector<PaceRow> pace;  ///< empty until something has moved
  friend bool operator==(const RenderingView&, const RenderingView&) = default;
};

/// A sentence about what was just done, such as where a file went.
struct Notice {
  std::string text;  ///< empty: there is none
  bool bad = false;
  friend bool operator==(const Notice&, const Notice&) = default;
};

/// What is heard, and where.
struct SoundView {
  bool there = false;  ///< a device plays
  int volume = 100;    ///< percent
  bool muted = false;
  int peak_percent = 0;  ///< how loud what plays is, volume and mute left out: 100 is the most
                         ///< there can be, 0 is 48 dB below
  std::string device;    ///< the one that was chosen; empty: the usual one
  std::vector<std::string> devices;  ///< what there is to choose from
  friend bool operator==(const SoundView&, const SoundView&) = default;
};

/// What is said, in writing.
struct SpokenView {
  std::string title;    ///< of the stream; empty: it has none
  std::string caption;  ///< of this moment, UTF-8; empty: nothing is said
  bool shown = true;    ///< over the face
  friend bool operator==(const SpokenView&, const SpokenView&) = default;
};

/// The streams of the server whose address is in the form.
struct StreamsView {
  bool asking = false;
  std::vector<protocol::ListedStream> streams;
  std::string problem;  ///< why there are none, a sentence
  friend bool operator==(const StreamsView&, const StreamsView&) = default;
};

enum class FaceKind : std::uint8_t {
  Shipped,
  Own,  ///< in the user's own data folder
  Elsewhere,
};

/// A face to choose.
struct FaceEntry {
  std::string name;
  std::string folder;
  FaceKind kind = FaceKind::Shipped;
  friend bool operator==(const FaceEntry&, const FaceEntry&) = default;
};

struct FacesView {
  std::shared_ptr<const std::vector<FaceEntry>> entries;  ///< by kind, then by name; null: none
  std::string shown;                                      ///< the folder of the face in the window
  std::string elsewhere;  ///< the folder that those of that kind are in; empty: there is none
  friend bool operator==(const FacesView&, const FacesView&) = default;
};

struct LanguageEntry {
  std::string code;  ///< "fr"
  std::string name;  ///< "Français"
  friend bool operator==(const LanguageEntry&, const LanguageEntry&) = default;
};

struct DisplayView {
  DisplaySettings settings;
  std::string language;  ///< the code of the one that is used
  std::vector<LanguageEntry> languages;
  friend bool operator==(const DisplayView&, const DisplayView&) = default;
};

/// Names of files.
struct VideoView {
  std::string recording;   ///< empty: none is being recorded
  std::string completing;  ///< what was recorded before; empty: its file is there
  friend bool operator==(const VideoView&, const VideoView&) = default;
};

/// The file for other programs that is being written in the background.
struct ExportView {
  std::string file;     ///< empty: none
  int percent = 0;      ///< of the movement in it
  bool ending = false;  ///< it was cancelled and is not over yet
  friend bool operator==(const ExportView&, const ExportView&) = default;
};

struct GuiModel {
  RemoteSettings remote_settings;   ///< those in force; the form begins with them
  std::vector<std::string> recent;  ///< addresses that answered, the last one first
  StreamsView streams;
  PlayingView playing;
  LocalView local;
  MirrorView mirror;
  SoundView sound;
  SpokenView spoken;
  TablesView tables;
  std::string sample;                     ///< a stream file that shows what there is; empty: none
  std::vector<std::string> recent_files;  ///< the last one first
  FacesView faces;
  GalleryView gallery;
  PictureSettings pictures;
  BrowserView browser;
  Notice notice;
  AnimationSettings animation;
  EditorView editor;
  ComposerView composer;
  std::shared_ptr<const std::vector<AuEntry>> known_aus;  ///< always there
  VideoView video;
  ExportView exported;
  std::string onsets;  ///< where the times go at which faces are shown; empty: nowhere
  ExpressionsView expressions;
  TransitionSettings transition;
  RenderingView rendering;
  DisplayView display;
  bool asks_to_leave = false;  ///< there are unsaved changes and the user wants to go
  friend bool operator==(const GuiModel&, const GuiModel&) = default;
};

}  // namespace aucast::gui
