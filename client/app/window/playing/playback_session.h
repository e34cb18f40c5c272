#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/app/notices.h"
#include "client/app/playback_meter.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/played.h"
#include "client/app/window/playing/playing_stream.h"
#include "client/app/window/playing/remote_stream.h"
#include "client/app/window/playing/server_choice.h"
#include "client/app/window/playing/sound_session.h"
#include "client/gui/gui_commands.h"
#include "client/net/remote_source.h"
#include "client/sound/heard_player.h"

namespace aucast::app {

/// What plays in the window, the face that it moves and the sound beside it, and what the panels
/// show of them. PlayingStream has what differs between a server's stream and one loaded in full.
/// What the constructor takes must outlive it. Thread: the player's.
class PlaybackSession {
 public:
  /// `shown`: the activations of the face in the window, whichever session they are from; another
  /// stream begins from there.
  PlaybackSession(const pipeline::AuMapping& mapping, const PlayerOptions& options,
                  PlayerStats& stats, Notices& notices, const std::vector<float>& shown);

  /// Plays this from now on; null: nothing. `name`: of a stream loaded in full.
  void open(std::unique_ptr<playback::Playback> playback, std::string name, Instant now);
  void open(std::vector<playback::Keyframe> keyframes, std::string name, Instant now);
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

  /// Which servers are asked for.
  [[nodiscard]] ServerChoice& servers() { return servers_; }
  [[nodiscard]] const ServerChoice& servers() const { return servers_; }
  /// ServerChoice's, for the sound device that there is: one may have been plugged in since.
  [[nodiscard]] Result<net::RemoteOptions> server_of(const gui::RemoteSettings& settings) const {
    return servers_.server_of(settings, sound_.has_device());
  }

  /// With sound, the face that belongs to what is heard.
  [[nodiscard]] const std::vector<float>& activations() { return player_.activations(); }
  /// That face is on the display.
  void face_shown() { player_.sound().face_shown(); }
  /// The keyframe under way, from 1; 0: none has begun.
  [[nodiscard]] std::uint64_t keyframe() const {
    return stream_ == nullptr ? 0 : stream_->playback().progress().keyframe;
  }
  /// The AUs of that face, rules applied.
  [[nodiscard]] const AuFrame& aus() const { return player_.face().face().aus; }
  /// Playing has come to its end; false while nothing was ever opened.
  [[nodiscard]] bool over() const { return player_.over(); }
  /// The face stands, and Resume would move it.
  [[nodiscard]] bool stands() const { return stream_ != nullptr && stream_->stands(); }
  /// How long the window may wait before it should look again.
  [[nodiscard]] Duration idle_time(Instant now) const;
  [[nodiscard]] std::string title() const;
  /// `stale` and `eased` hold for the face of this session: another face in the window is neither.
  [[nodiscard]] gui::PlayingView playing_view() const;
  [[nodiscard]] gui::LocalView local_view() const {
    return stream_ == nullptr ? gui::LocalView() : stream_->local_view();
  }

 private:
  [[nodiscard]] bool running() const { return stream_ != nullptr && stream_->running(); }
  [[nodiscard]] std::unique_ptr<PlayingStream> stream_of(
      std::unique_ptr<playback::Playback> playback, std::string name);
  void begin(std::unique_ptr<PlayingStream> stream, Instant now);
  void open_remote(net::RemoteOptions options, RemoteStream::Server server, Instant now);
  bool connect(const gui::RemoteSettings& settings, Instant now);
  void object(Instant now);
  void begun(const playback::KeyframeBegun& keyframe, Instant at);
  void explain();
  [[nodiscard]] std::vector<gui::AuRow> au_rows() const;

  const pipeline::AuMapping& mapping_;
  const PlayerOptions& options_;
  PlayerStats& stats_;
  Notices& notices_;
  const std::vector<float>& shown_;
  ServerChoice servers_;
  playback::BufferOptions buffers_;  ///< of the last server, or as the command line has them

  sound::HeardPlayer player_;
  PlaybackMeter meter_;
  std::unique_ptr<PlayingStream> stream_;  ///< null: nothing was opened
  SoundSession sound_;
  std::unique_ptr<PlayingStream> retired_;      ///< saying its last words
  std::vector<face::RuleExplained> explained_;  ///< the rules that fired in this keyframe
};

}  // namespace aucast::app
