#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/app/window/local_stream.h"
#include "client/app/window/playback_history.h"
#include "client/face/face.h"
#include "client/gui/composer.h"
#include "client/gui/expression_editor.h"
#include "client/gui/file_browser.h"
#include "client/gui/gui_commands.h"
#include "client/gui/gui_model.h"
#include "client/gui/kept_settings.h"
#include "client/gui/transition.h"
#include "client/pipeline/face_pipeline.h"
#include "client/pipeline/idle_face.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/playback_controller.h"

namespace aucast::app {

/// What happens in the window, without the window: plays a source, carries out what the panels ask
/// for, says what they show and which face it is. Time is handed in.
/// The assets and options must outlive it. Thread: the player's.
class WindowSession {
 public:
  /// `source` may be null: the face at rest.
  WindowSession(const Assets& assets, const PlayerOptions& options,
                std::unique_ptr<playback::KeyframeSource> source, PlayerStats& stats);
  ~WindowSession();
  /// Begins with what the window remembers; before anything else. A complaint about it is shown.
  void begin_with(const gui::KeptSettings& settings, const std::string& complaint, Instant now);
  /// What it should remember now.
  [[nodiscard]] gui::KeptSettings kept() const;
  WindowSession(const WindowSession&) = delete;
  WindowSession& operator=(const WindowSession&) = delete;

  /// The face with the edits of the expression panel; its mesh never changes.
  [[nodiscard]] const face::Face& face() const { return face_; }

  /// Moves playback to `now`.
  void advance(Instant now);
  /// Carries out what a panel asked for. LookFrom is the camera's owner's.
  void apply(const gui::GuiCommand& command, Instant now);
  void toggle_pause(Instant now);

  // What is meant by the keys depends on what the face shows.
  void undo(Instant now);
  void redo(Instant now);
  void save(Instant now);

  /// The face of this moment; one activation per channel. Overwritten by the next call.
  [[nodiscard]] const std::vector<float>& activations(Instant now);
  [[nodiscard]] gui::GuiModel model() const;
  /// "AUcast - playing", for the title of the window.
  [[nodiscard]] std::string title() const;
  /// Longest time for which nothing changes by itself.
  [[nodiscard]] Duration rest(Instant now) const;

  /// Playing has come to its end; false while nothing was ever opened.
  [[nodiscard]] bool over() const;
  /// The user wants to leave: at once, unless there are changes to be asked about.
  void ask_to_leave();
  [[nodiscard]] bool leaving() const { return leaving_; }
  [[nodiscard]] const gui::RenderingSettings& rendering() const { return rendering_; }
  /// A sentence for the user, for a while.
  void say(std::string text, bool bad, Instant now);
  /// The video being recorded, for the panel; empty: none.
  void set_recording(std::string file) { recording_ = std::move(file); }
  /// The pace of drawing, for the panel.
  void set_pace(std::vector<gui::PaceRow> pace) { pace_ = std::move(pace); }

  /// Stops what plays, completes the statistics and hands out the last source.
  [[nodiscard]] std::unique_ptr<playback::KeyframeSource> finish(Instant now);

 private:
  /// Whose face is shown.
  enum class Shown : std::uint8_t { Playback, Editor, Composer };

  void carry_out(const gui::Connect& command, Instant now);
  void carry_out(const gui::Pause&, Instant now);
  void carry_out(const gui::Resume&, Instant now);
  void carry_out(const gui::Stop&, Instant now);
  void carry_out(const gui::ChangeAnimation& command, Instant now);
  void carry_out(const gui::ShowExpression& command, Instant now);
  void carry_out(const gui::ChangeTransition& command, Instant now);
  void carry_out(const gui::SetChannel& command, Instant now);
  void carry_out(const gui::SetLinked& command, Instant now);
  void carry_out(const gui::LoadAu& command, Instant now);
  void carry_out(const gui::SaveAu& command, Instant now);
  void carry_out(const gui::ShowAus& command, Instant now);
  void carry_out(const gui::TakePicture&, Instant) {}
  void carry_out(const gui::ToggleVideo&, Instant) {}
  void carry_out(const gui::RevertAu&, Instant now);
  void carry_out(const gui::NeutralFace&, Instant now);
  void carry_out(const gui::Undo&, Instant now);
  void carry_out(const gui::Redo&, Instant now);
  void carry_out(const gui::ChangeRendering& command, Instant now);
  void carry_out(const gui::LookFrom&, Instant) {}
  void carry_out(const gui::Leave& command, Instant now);
  void carry_out(const gui::LocalCommand& command, Instant now);
  void carry_out(const gui::ComposerCommand& command, Instant now);
  void carry_out(const gui::Browse& command, Instant now);
  void carry_out(const gui::EnterFolder& command, Instant now);
  void carry_out(const gui::ChooseFile& command, Instant now);
  void carry_out(const gui::CloseBrowser&, Instant now);
  void carry_out(const gui::OpenStream& command, Instant now);
  void carry_out(const gui::CloseNotice&, Instant now);

  void edit(Instant now);
  void take_slowly(std::vector<float> target, Instant now);
  /// `cut_at`: where the one before was left.
  void begin_keyframe(const AuFrame& aus, double cut_at = 1);
  void explain(const AuFrame& aus);
  void begin_stream(Instant now);
  void trace_progress(Instant now);
  void advance_local(Instant now);
  // Of the composer.
  void compose(const gui::ComposeAu& command, Instant now);
  void compose(const gui::ComposeMood& command, Instant now);
  void compose(const gui::ComposeNeutral&, Instant now);
  void compose(const gui::ComposeTime& command, Instant now);
  void compose(const gui::AddKeyframe&, Instant now);
  void compose(const gui::ChooseKeyframe& command, Instant now);
  void compose(const gui::RemoveKeyframe&, Instant now);
  void compose(const gui::MoveKeyframe& command, Instant now);
  void compose(const gui::UndoComposing&, Instant now);
  void compose(const gui::RedoComposing&, Instant now);
  void compose(const gui::NewComposition&, Instant now);
  void compose(const gui::PlayComposition&, Instant now);
  void compose(const gui::SaveComposition&, Instant now);
  void edit_composition(Instant now);
  void show_composed();
  void load_composition(const std::filesystem::path& file, Instant now);
  void save_composition(const std::filesystem::path& file, Instant now);
  [[nodiscard]] std::filesystem::path own_folder() const;
  [[nodiscard]] gui::ComposerView composer_view() const;
  void play_local(std::string name, const std::vector<playback::TimedAus>& keyframes);
  void replace_source(std::unique_ptr<playback::KeyframeSource> source,
                      std::optional<Milliseconds> speed, Instant now);
  void export_keyframes(const std::filesystem::path& file, Instant now);
  void list_aus();
  void remember(Instant now);
  void add_idle_life(Instant now);
  [[nodiscard]] Result<std::string> save_recording(int number);
  [[nodiscard]] gui::RemoteView remote_view() const;
  [[nodiscard]] gui::EditorView editor_view() const;
  void describe_traffic(const playback::SourceStatus& status, gui::RemoteView& view) const;
  [[nodiscard]] bool running() const { return source_ != nullptr && !over(); }

  const Assets& assets_;
  const PlayerOptions& options_;
  PlayerStats& stats_;
  face::Face face_;
  face::RuleSet rules_;  ///< of animation_.rules; the pipeline reads it
  gui::AnimationSettings animation_;
  gui::RemoteSettings remote_settings_;
  std::vector<std::string> recent_;  ///< addresses, the last one first
  playback::BufferOptions buffers_;

  std::unique_ptr<playback::KeyframeSource> source_;
  std::vector<std::unique_ptr<playback::KeyframeSource>> retired_;  ///< saying their last words
  std::uint64_t local_played_ = 0;
  std::optional<LocalStream> local_;  ///< then source_ only stands for it
  playback::PlaybackController controller_;
  std::optional<pipeline::FacePipeline> pipeline_;  ///< always there; made anew for a new source
  std::optional<Instant> first_begin_;
  std::uint64_t traced_ = 0;  ///< keyframes reached
  std::vector<gui::AuRow> aus_;

  Shown shown_ = Shown::Playback;
  gui::ExpressionEditor editor_;
  std::optional<gui::Transition> transition_;
  gui::TransitionSettings transition_settings_;
  std::string saved_to_;
  bool save_failed_ = false;
  std::vector<gui::AuRow> compound_;

  gui::RenderingSettings rendering_;
  std::vector<gui::ExpressionButton> buttons_;
  std::shared_ptr<const std::vector<gui::AuEntry>> known_aus_;
  std::string recording_;
  std::vector<gui::ComposedKeyframe> received_;  ///< begun so far, of what cannot be asked again
  std::vector<gui::PaceRow> pace_;
  pipeline::IdleFace idle_;
  std::vector<float> held_;         ///< the face before the first keyframe of a new source
  std::vector<float> activations_;  ///< as shown, idle life included
  std::vector<float> face_now_;     ///< as shown, idle life left out

  PlaybackHistory history_;
  AuFrame aus_before_;  ///< of the keyframe before, after the rules
  gui::Composer composer_;
  std::uint64_t composed_revision_ = 0;  ///< that composer_rows_ are of
  std::shared_ptr<const std::vector<gui::TimelineRow>> composer_rows_;
  std::string composer_total_;
  std::shared_ptr<const std::vector<gui::PadPoint>> pad_;
  std::optional<std::array<float, 2>> pad_at_;
  std::vector<float> composed_;  ///< the face of the keyframe being composed
  gui::FileBrowser browser_;
  std::filesystem::path own_folder_;
  std::filesystem::path last_folder_;  ///< where the file dialog begins
  gui::Notice notice_;
  Instant notice_until_{};
  bool asks_to_leave_ = false;
  bool leaving_ = false;
};

}  // namespace aucast::app
