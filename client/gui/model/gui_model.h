#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/muscle_mixer.h"
#include "client/gui/model/browser_view.h"
#include "client/gui/model/composer_view.h"
#include "client/gui/model/display_settings.h"
#include "client/gui/model/face_names.h"
#include "client/gui/model/gallery_view.h"
#include "client/gui/model/mirror_view.h"
#include "client/gui/model/picture_settings.h"
#include "client/gui/model/remote_settings.h"
#include "client/gui/model/stream_view.h"
#include "client/gui/model/table_settings.h"
#include "client/playback/blinking.h"
#include "client/playback/interpolator.h"
#include "client/view/style.h"

namespace aucast::gui {

/// How AUs become a face; may change while it plays.
struct AnimationSettings {
  face::Mixer mixer = face::Mixer::Maximum;
  std::string rules = "facs";  ///< as in --rules
  playback::Interpolation interpolation = playback::Interpolation::Linear;
  friend bool operator==(const AnimationSettings&, const AnimationSettings&) = default;
};

/// A line of the expression editor: one channel, or a left and a right one under one name.
struct ChannelRow {
  std::string name;  ///< in words: "zygomaticus major"
  float maximum = 2;
  int left = -1;  ///< index of the left or the central channel; -1: there is none
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
  bool active = false;  ///< the face shows what is edited
  bool aside = false;   ///< something is being edited, but the face shows something else
  std::vector<ChannelGroup> groups;  ///< the channels of what is edited or, if nothing is, of the
                                     ///< face that is shown
  bool linked = true;
  int au = -1;  ///< the AU being edited; -1: none
  bool unsaved = false;
  std::map<int, std::string> names;  ///< names of AUs that were typed and have not been saved yet
  bool can_undo = false;
  bool can_redo = false;
  std::vector<AuRow> compound;  ///< the AUs that were combined last; empty: none
  friend bool operator==(const EditorView&, const EditorView&) = default;
};

/// An AU in the editor's list.
struct AuEntry {
  int number = 0;
  std::string name;     ///< of FACS, or the user's own
  std::string muscles;  ///< what it drives: "zygomaticus major 0.8, lip corner 1"
  std::string looks;    ///< what a face with it looks like; empty: unknown
  bool own = false;     ///< the user has made or changed it
  bool shipped = true;  ///< the player came with it, or with another version
  friend bool operator==(const AuEntry&, const AuEntry&) = default;
};

enum class ExpressionKind : std::uint8_t {
  Main,   ///< the first of the sets of AUs with one label; shown as a button
  Macro,  ///< muscles, as in the expressions of Waters' program; shown as a button
  Other,  ///< another set of AUs with the same label; shown in a list
};

/// An expression to choose.
struct ExpressionButton {
  std::string label;
  std::string aus;  ///< as in a packet; "0" for muscles alone
  ExpressionKind kind = ExpressionKind::Main;
  std::string source{};  ///< who describes it in this way, in words
  std::string name{};    ///< its name on the command line; unlike a label, it is unique
  friend bool operator==(const ExpressionButton&, const ExpressionButton&) = default;
};

/// The named expressions, and the one that the face shows.
struct ExpressionsView {
  std::vector<ExpressionButton> buttons;
  int chosen = -1;    ///< index of the one that is shown; -1: none is, or it has been changed since
  int percent = 100;  ///< strength of the expression, 0-100
  std::string aus;    ///< AUs of the chosen one at this strength, as in a packet; empty: none
  friend bool operator==(const ExpressionsView&, const ExpressionsView&) = default;
};

/// How the face goes from what it shows to an expression.
struct TransitionSettings {
  static constexpr int kFramesMax = 500;
  static constexpr int kFrameMsMax = 1000;

  int frames = 50;   ///< number of in-between frames, 1 to kFramesMax
  int frame_ms = 5;  ///< 1 to kFrameMsMax
  bool cosine = false;
  friend bool operator==(const TransitionSettings&, const TransitionSettings&) = default;
};

/// The background. None: transparent in pictures, a chequer in the window.
enum class Ground : std::uint8_t { Studio, Black, Grey, White, None };
enum class Facing : std::uint8_t { Front, ThreeQuarter, Profile };

/// How far the light can be turned to either side, and up and down.
inline constexpr int kLightYawMaxDeg = 180;
inline constexpr int kLightPitchMaxDeg = 80;
inline constexpr int kLightPercentMax = 200;
/// The largest seed that is shown; a random seed may be larger.
inline constexpr int kSeedShownMax = 999'999;
[[nodiscard]] constexpr int shown_seed(std::uint64_t seed) {
  return seed < kSeedShownMax ? static_cast<int>(seed) : kSeedShownMax;
}

struct RenderingSettings {
  view::Layers layers;
  Ground ground = Ground::Studio;
  int light_yaw_deg = -38;   ///< of the key light, to the subject's left; up to kLightYawMaxDeg
  int light_pitch_deg = 34;  ///< up; up to kLightPitchMaxDeg
  int light_percent = 100;   ///< 0 to kLightPercentMax
  bool blinking = false;
  playback::BlinkOptions blink;
  friend bool operator==(const RenderingSettings&, const RenderingSettings&) = default;
};

/// A measure of how fast pictures are drawn, such as "pictures a second", "24".
struct PaceRow {
  std::string name;
  std::string value;
  friend bool operator==(const PaceRow&, const PaceRow&) = default;
};

struct RenderingView {
  RenderingSettings settings;
  std::vector<PaceRow> pace;  ///< empty until something moves
  friend bool operator==(const RenderingView&, const RenderingView&) = default;
};

/// A sentence about what was just done, such as where a file was saved.
struct Notice {
  std::string text;  ///< empty: no notice
  bool bad = false;
  friend bool operator==(const Notice&, const Notice&) = default;
};

/// What is heard, and where.
struct SoundView {
  bool there = false;   ///< there is a sound device
  bool missed = false;  ///< sound is wanted, but there is no device
  int volume = 100;     ///< percent
  bool muted = false;
  int peak_percent = 0;  ///< level of the sound before volume and mute; 100: the maximum, 0: 48 dB
                         ///< below the maximum
  std::string device;    ///< the chosen one; empty: the default one
  std::vector<std::string> devices;  ///< those to choose from
  friend bool operator==(const SoundView&, const SoundView&) = default;
};

/// Title and captions.
struct SpokenView {
  std::string title;    ///< of the stream; empty: it has none
  std::string caption;  ///< to be shown now, UTF-8; empty: none
  bool shown = true;    ///< whether captions are shown over the face
  friend bool operator==(const SpokenView&, const SpokenView&) = default;
};

/// The files of videos that are being made.
struct VideoView {
  std::string recording;   ///< the one being recorded; empty: none
  std::string completing;  ///< the one recorded before, whose file is being completed; empty: none
  friend bool operator==(const VideoView&, const VideoView&) = default;
};

/// A file for other programs that is being written in the background.
struct ExportView {
  std::string file;     ///< empty: none
  int percent = 0;      ///< how much of the movement has been written
  bool ending = false;  ///< the writing was cancelled, but has not ended yet
  friend bool operator==(const ExportView&, const ExportView&) = default;
};

/// What the panels show, as plain data that is made anew for every frame. A panel is a function
/// from this to the commands of gui_commands.h; it keeps only the state of its widgets.
struct GuiModel {
  RemoteSettings remote_settings;   ///< those in use; the form begins with them
  std::vector<std::string> recent;  ///< addresses that answered, the newest first
  StreamsView streams;
  PlayingView playing;
  LocalView local;
  MirrorView mirror;
  SoundView sound;
  SpokenView spoken;
  TablesView tables;
  std::string sample;                     ///< a stream file for demonstration; empty: none
  std::vector<std::string> recent_files;  ///< the newest first
  FacesView faces;
  GalleryView gallery;
  PictureSettings pictures;
  std::string picture_folder;  ///< the full path of the folder in `pictures`
  BrowserView browser;
  CredentialFiles credentials;
  Notice notice;
  AnimationSettings animation;
  EditorView editor;
  ComposerView composer;
  std::shared_ptr<const std::vector<AuEntry>> known_aus;  ///< never null
  VideoView video;
  ExportView exported;
  std::string onsets;  ///< the file for the times at which faces are shown; empty: none
  ExpressionsView expressions;
  TransitionSettings transition;
  RenderingView rendering;
  DisplayView display;
  bool asks_to_leave = false;  ///< the user wants to leave, but something would be lost
  friend bool operator==(const GuiModel&, const GuiModel&) = default;
};

}  // namespace aucast::gui
