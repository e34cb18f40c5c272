#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/app/missing_aus.h"
#include "client/app/notices.h"
#include "client/app/playback_meter.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/played.h"
#include "client/app/window/playing/playing_stream.h"
#include "client/app/window/playing/remote_stream.h"
#include "client/app/window/playing/server_choice.h"
#include "client/app/window/playing/sound_session.h"
#include "client/gui/model/gui_commands.h"
#include "client/net/remote_source.h"
#include "client/sound/heard_player.h"

namespace aucast::app {

/// What plays in the window, the face that it moves, its sound, and what the panels show of them.
/// What differs between a server's stream and one that is available whole is in PlayingStream. The
/// constructor's arguments must outlive it. Thread: the player's.
class PlaybackSession {
 public:
  /// `shown`: the activations of the face in the window, whichever session they come from. The face
  /// of a new stream starts from them.
  PlaybackSession(const pipeline::AuMapping& mapping, const PlayerOptions& options,
                  PlayerStats& stats, Notices& notices, const std::vector<float>& shown);

  /// Plays this stream from now on; null: plays nothing. `name`: the name of a stream that is
  /// available whole; ignored for a server's stream.
  void open(std::unique_ptr<playback::Playback> playback, std::string name, Instant now);
  void open(playback::KeyframeList keyframes, std::string name, Instant now);
  /// Plays the stream of the user's own camera, with the lowest delay and without voice. Its
  /// address is not remembered.
  void watch_own(const net::Endpoint& endpoint, std::string token, Instant now);
  /// Says that what plays was read from this file. If there are a sound file and captions beside
  /// it, they are used.
  void play_beside(const std::filesystem::path& file, Instant now);
  /// Sound and captions of what plays.
  [[nodiscard]] SoundSession& sound() { return sound_; }
  [[nodiscard]] const SoundSession& sound() const { return sound_; }
  /// Returns true if the face that plays is to be shown.
  bool apply(const gui::PlaybackCommand& command, Instant now);
  void advance(Instant now);
  /// Call it when the mapping or the interpolation has changed.
  void remake(playback::Interpolation interpolation);
  /// Call it when the mapping has another face.
  void change_face();
  /// Stops what plays, completes the statistics and hands out what played last; may be null.
  [[nodiscard]] std::unique_ptr<playback::Playback> finish(Instant now);
  /// All keyframes of a stream that is available whole; of a server's stream those that have begun
  /// so far, at most Played::kKept.
  [[nodiscard]] Played played() const;

  /// The server that the user wants.
  [[nodiscard]] ServerChoice& servers() { return servers_; }
  [[nodiscard]] const ServerChoice& servers() const { return servers_; }
  /// As ServerChoice::server_of(), with the sound device that there is now. It may have been
  /// plugged in since the start.
  [[nodiscard]] Result<net::RemoteOptions> server_of(const gui::RemoteSettings& settings) const {
    return servers_.server_of(settings, sound_.has_device());
  }

  /// The activations of this session's face; if there is sound, of the face for what is heard now.
  [[nodiscard]] const std::vector<float>& activations() { return player_.activations(); }
  /// Call it when the face of activations() is on the display.
  void face_shown() { player_.sound().face_shown(); }
  /// The number of the keyframe under way, from 1; 0: none has begun.
  [[nodiscard]] std::uint64_t keyframe() const {
    return stream_ == nullptr ? 0 : stream_->playback().progress().keyframe;
  }
  /// The number of the last keyframe that the face has reached, from 1; 0: none.
  [[nodiscard]] std::uint64_t reached() const;
  /// The AUs of the face, after the rules.
  [[nodiscard]] const AuFrame& aus() const { return player_.face().face().aus; }
  /// Whether playing has come to its end; false if nothing has been opened.
  [[nodiscard]] bool over() const { return player_.over(); }
  /// Whether the face does not move and Resume would make it move.
  [[nodiscard]] bool stands() const { return stream_ != nullptr && stream_->stands(); }
  /// How long the window may wait before it calls advance() again.
  [[nodiscard]] Duration idle_time(Instant now) const;
  [[nodiscard]] std::string title() const;
  /// `stale` and `eased` describe the face of this session. If the window shows another session's
  /// face, the caller must set both to false.
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
  playback::BufferOptions buffers_;  ///< those of the last server, or of the command line

  sound::HeardPlayer player_;
  PlaybackMeter meter_;
  MissingAus missing_;
  std::unique_ptr<PlayingStream> stream_;  ///< null: nothing has been opened
  SoundSession sound_;
  std::unique_ptr<PlayingStream> retired_;  ///< the previous stream, which is still saying goodbye
                                            ///< to its server
  std::vector<face::RuleExplained> explained_;  ///< the rules that changed something in the
                                                ///< keyframe under way
};

}  // namespace aucast::app
