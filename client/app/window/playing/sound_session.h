#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/app/notices.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/spoken_text.h"
#include "client/gui/model/gui_commands.h"
#include "client/sound/file_track.h"
#include "client/sound/heard_player.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_player.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// Sound and captions of what plays in the window: the device, the volume, the voice or sound file,
/// the captions; and what the panels show of them. The constructor's arguments must outlive it.
/// Thread: the player's.
class SoundSession {
 public:
  SoundSession(const SoundOptions& options, sound::HeardPlayer& player, Notices& notices);

  /// Call it when the player plays something else.
  void begin_again();
  /// Call it when the stream that plays was read from this file. Uses the sound file and the
  /// captions beside the file, if there are any.
  void play_beside(const std::filesystem::path& file, Instant now);
  /// Plays this sound file in place of the sound that the stream itself has, and shows a notice.
  /// `stream`: the stream's name. Fails with Failed if there is no device, or as open_sound_file()
  /// does.
  [[nodiscard]] Result<void> play_file(const std::filesystem::path& sound,
                                       const std::string& stream, Instant now);
  /// Call it when the player has been advanced to `now`.
  void advanced(Instant now);

  /// Sets the device; null: none.
  void set_out(std::unique_ptr<sound::SoundOut> out);
  /// See SoundPlayer::set_tap().
  void set_tap(sound::SoundPlayer::Tap tap) { player_.sound().set_tap(std::move(tap)); }
  /// Whether there is a device.
  [[nodiscard]] bool has_device() const { return has_device_; }

  void apply(const gui::SoundCommand& command, Instant now);
  /// Sets the volume, in percent, without a notice.
  void set_volume(int percent);
  [[nodiscard]] int volume() const { return volume_; }
  /// Changes the volume by `by` percent.
  void change_volume(int by, Instant now);

  [[nodiscard]] gui::SoundView sound_view() const;
  [[nodiscard]] gui::SpokenView spoken_view() const;

 private:
  void play_sound_file(Instant now);
  void toggle_mute(Instant now);
  void choose_device(const std::string& name, Instant now);

  sound::HeardPlayer& player_;
  Notices& notices_;
  std::unique_ptr<sound::FileTrack> track_;  ///< null: the sound comes with what plays
  bool wanted_;                              ///< sound is not turned off by the options
  bool has_device_ = false;
  bool missed_ = false;               ///< sound is wanted, and no device plays it
  std::string device_;                ///< the chosen one; empty: the default one
  std::vector<std::string> devices_;  ///< those to choose from
  std::filesystem::path file_;        ///< the file from which the stream was read; empty: none
  SpokenText spoken_;
  bool shows_spoken_ = true;
  int volume_;
  bool muted_;
};

}  // namespace aucast::app
