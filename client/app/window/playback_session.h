#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/app/playback_meter.h"
#include "client/app/player_options.h"
#include "client/app/window/notices.h"
#include "client/app/window/playback_history.h"
#include "client/app/window/played.h"
#include "client/app/window/sound_session.h"
#include "client/gui/gui_commands.h"
#include "client/net/remote_source.h"
#include "client/playback/seekable_playback.h"
#include "client/sound/heard_player.h"

namespace aucast::app {

/// The window waits no longer than this while something moves.
inline constexpr Milliseconds kFrameMax{20};

/// What plays in the window, a server's stream or one loaded in full, and what the panels show of
/// it. What the constructor takes must outlive it. Thread: the player's.
class PlaybackSession {
 public:
  /// `shown`: the activations of the face in the window, whichever session they are from; another
  /// stream begins from there.
  PlaybackSession(const pipeline::AuMapping& mapping, const PlayerOptions& options,
                  PlayerStats& stats, Notices& notices, const std::vector<float>& shown);

  /// Plays this from now on; null: nothing. `name`: of a stream loaded in full.
  void open(std::unique_ptr<playback::Playback> playback, std::string name, Instant now);
  void open(std::vector<playback::TimedAus> keyframes, std::string name, Instant now);
  /// Plays the stream of one's own camera, with the lowest delay and without its voice. Its address
  /// is not remembered.
  void watch_own(const net::Endpoint& endpoint, Instant now);
  /// What plays was read from this file: the sound file and the captions beside it, if there are
  /// any, belong to it.
  void play_beside(const std::filesystem::path& file, Instant now);
  /// What is heard and read beside it.
  [[nodiscard]] SoundSession& sound() { return sound_; }
  [[nodiscard]] const SoundSession& sound() const { return sound_; }
  /// True when the face that plays is to be shown.
  bool apply(const gui::PlaybackCommand& command, Instant now);
  void advance(Instant now);
  /// Mapping or interpolation have changed.
  void remake(playback::Interpolation interpolation);
  /// The face of the mapping has become another one.
  void change_face();
  /// Stops what plays, completes the statistics and hands out what played last; may be null.
  [[nodiscard]] std::unique_ptr<playback::Playback> finish(Instant now);
  /// All of a stream loaded in full; of a server's stream the keyframes that have begun so far, if
  /// they are not too many to be kept.
  [[nodiscard]] Played played() const;

  void set_remote(const gui::RemoteSettings& settings, std::vector<std::string> recent);
  /// The server that a form names and how to reach it. Error when a file of certificate or token
  /// cannot be used.
  [[nodiscard]] Result<net::RemoteOptions> server_of(const gui::RemoteSettings& settings) const;
  [[nodiscard]] const gui::RemoteSettings& remote_settings() const { return remote_settings_; }
  /// The same, with the last server that answered: one that was mistyped is not worth keeping.
  [[nodiscard]] gui::RemoteSettings remote_to_keep() const {
    return gui::with_server_of(remote_settings_, worked_);
  }
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }

  /// With sound, the face that belongs to what is heard.
  [[nodiscard]] const std::vector<float>& activations() { return player_.activations(); }
  /// That face is on the display.
  void face_shown() { player_.sound().face_shown(); }
  /// The keyframe under way, from 1; 0: none has begun.
  [[nodiscard]] std::uint64_t keyframe() const {
    return playback_ == nullptr ? 0 : playback_->progress().keyframe;
  }
  /// The AUs of that face, rules applied.
  [[nodiscard]] const AuFrame& aus() const { return player_.face().face().aus; }
  /// Playing has come to its end; false while nothing was ever opened.
  [[nodiscard]] bool over() const { return player_.over(); }
  /// The face stands, and Resume would move it.
  [[nodiscard]] bool stands() const;
  /// How long the window may wait before it should look again.
  [[nodiscard]] Duration idle_time(Instant now) const;
  [[nodiscard]] std::string title() const;
  /// `stale` and `eased` hold for the face of this session: another face in the window is neither.
  [[nodiscard]] gui::RemoteView remote_view() const;
  [[nodiscard]] gui::LocalView local_view() const;

 private:
  [[nodiscard]] bool running() const { return playback_ != nullptr && !playback_->over(); }
  [[nodiscard]] playback::SeekablePlayback* seekable() const;
  bool connect(const gui::RemoteSettings& settings, Instant now);
  bool resume(Instant now);
  [[nodiscard]] int step_fps() const;
  bool apply_local(const gui::LocalCommand& command, Instant now);
  void toggle_repeat(playback::LocalPlayback& playhead, Instant now);
  void begun(const playback::KeyframeBegun& keyframe, Instant at);
  void explain();
  void remember(Instant now);
  void describe_traffic(const playback::SourceStatus& status, gui::RemoteView& view) const;
  [[nodiscard]] std::vector<gui::AuRow> au_rows() const;

  const pipeline::AuMapping& mapping_;
  const PlayerOptions& options_;
  PlayerStats& stats_;
  Notices& notices_;
  const std::vector<float>& shown_;
  gui::RemoteSettings remote_settings_;
  gui::RemoteSettings worked_;       ///< its server is the last that answered, or was kept
  std::vector<std::string> recent_;  ///< addresses that answered, the latest first
  playback::BufferOptions buffers_;

  sound::HeardPlayer player_;
  PlaybackMeter meter_;
  std::unique_ptr<playback::Playback> playback_;
  SoundSession sound_;
  std::unique_ptr<playback::Playback> retired_;  ///< saying its last words
  std::string name_;                             ///< of a stream loaded in full
  std::shared_ptr<const gui::AuCurves> curves_;  ///< of the same
  std::vector<face::RuleExplained> explained_;   ///< the rules that fired in this keyframe
  Played received_;                              ///< of a server's stream
  PlaybackHistory history_;
  std::uint64_t tried_ = 0;  ///< attempts after a loss, as of the last frame
  Instant again_at_{};       ///< when the one under way began or begins
  Instant now_{};            ///< of the last frame
  bool answered_ = false;    ///< the server has sent something
  bool own_ = false;         ///< one's own face, which nobody else ends
  bool timed_ = false;       ///< the keyframe under way came with a time of its own
};

}  // namespace aucast::app
