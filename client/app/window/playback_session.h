#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/app/playback_meter.h"
#include "client/app/player_options.h"
#include "client/app/window/notices.h"
#include "client/app/window/playback_history.h"
#include "client/gui/composer.h"
#include "client/gui/gui_commands.h"
#include "client/pipeline/player.h"
#include "client/playback/seekable_playback.h"

namespace aucast::app {

/// What plays in the window: a server's stream or one that is there whole, and what the panels show
/// of it. All that is handed in must outlive it. Thread: the player's.
class PlaybackSession {
 public:
  /// `shown`: the face in the window, whoever's it is; another stream begins from there.
  PlaybackSession(const pipeline::AuMapping& mapping, const PlayerOptions& options,
                  PlayerStats& stats, Notices& notices, const std::vector<float>& shown);

  /// Plays this from now on; null: nothing. `name`: of a stream that is there whole.
  void open(std::unique_ptr<playback::Playback> playback, std::string name, Instant now);
  void open(std::vector<playback::TimedAus> keyframes, std::string name, Instant now);
  /// True when the face that plays is to be shown.
  bool apply(const gui::PlaybackCommand& command, Instant now);
  void advance(Instant now);
  /// Mapping or interpolation have changed.
  void remake(playback::Interpolation interpolation);
  /// Stops what plays, completes the statistics and hands out what played last; may be null.
  [[nodiscard]] std::unique_ptr<playback::Playback> finish(Instant now);
  /// What is played, from its beginning: a file as it is, of a server what has come so far. Returns
  /// a sentence about where it went.
  [[nodiscard]] Result<std::string> export_to(const std::filesystem::path& file) const;

  void set_remote(const gui::RemoteSettings& settings, std::vector<std::string> recent);
  [[nodiscard]] const gui::RemoteSettings& remote_settings() const { return remote_settings_; }
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }

  [[nodiscard]] const std::vector<float>& activations(Instant) const {
    return player_.face().activations;
  }
  /// Playing has come to its end; false while nothing was ever opened.
  [[nodiscard]] bool over() const { return playback_ != nullptr && playback_->over(); }
  /// The face stands, and Resume would move it.
  [[nodiscard]] bool stands() const;
  /// Longest time for which nothing changes by itself.
  [[nodiscard]] Duration idle_time(Instant now) const;
  [[nodiscard]] std::string title() const;
  /// `stale` and `eased` are meant for when its face is shown.
  [[nodiscard]] gui::RemoteView remote_view() const;
  [[nodiscard]] gui::LocalView local_view() const;

 private:
  [[nodiscard]] bool running() const { return playback_ != nullptr && !playback_->over(); }
  [[nodiscard]] playback::SeekablePlayback* seekable() const;
  bool connect(const gui::RemoteSettings& settings, Instant now);
  bool resume(Instant now);
  bool apply_local(const gui::LocalCommand& command, Instant now);
  void begun(const playback::KeyframeBegun& keyframe);
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
  std::vector<std::string> recent_;  ///< addresses, the last one first
  playback::BufferOptions buffers_;

  pipeline::Player player_;
  PlaybackMeter meter_;
  std::unique_ptr<playback::Playback> playback_;
  std::unique_ptr<playback::Playback> retired_;  ///< saying its last words
  std::string name_;                             ///< of a stream that is there whole
  std::vector<face::RuleExplained> explained_;   ///< the rules that fired in this keyframe
  gui::Composer::Keyframes received_;            ///< so far, of what cannot be asked for again
  PlaybackHistory history_;
};

}  // namespace aucast::app
