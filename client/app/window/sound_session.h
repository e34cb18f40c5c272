#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/app/player_options.h"
#include "client/app/window/notices.h"
#include "client/app/window/spoken_text.h"
#include "client/gui/gui_commands.h"
#include "client/playback/playback.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_player.h"
#include "client/sound/sound_track.h"
#include "common/time.h"

namespace aucast::app {

/// What is heard and read beside the face that plays in the window: the device, how loud it is, the
/// voice or sound file, the captions; and what the panels show of them. What the constructor takes
/// must outlive it. Thread: the player's.
class SoundSession {
 public:
  SoundSession(const SoundOptions& options, Notices& notices);

  /// This plays from now on; null: nothing. It must outlive this or the next open().
  void open(playback::Playback* playback);
  /// What plays was read from this file: the sound file and the captions beside it, if there are
  /// any, belong to it.
  void play_beside(const std::filesystem::path& file, Instant now);
  /// What plays has been advanced to now().
  void advanced(Instant now);

  /// It is heard there from now on; null: nowhere.
  void set_out(std::unique_ptr<sound::SoundOut> out);
  /// SoundPlayer's.
  void set_tap(sound::SoundPlayer::Tap tap) { player_.set_tap(std::move(tap)); }
  /// There is a device.
  [[nodiscard]] bool has_device() const { return has_device_; }

  void apply(const gui::SoundCommand& command, Instant now);
  /// By so many percent.
  void change_volume(int by, Instant now);

  /// The clock of what plays, and the rest of it: SoundPlayer's.
  [[nodiscard]] Instant now(Instant steady) { return player_.now(steady); }
  void face_shown() { player_.face_shown(); }
  [[nodiscard]] const sound::SoundPlayer& player() const { return player_; }

  [[nodiscard]] gui::SoundView sound_view() const;
  [[nodiscard]] gui::SpokenView spoken_view() const;

 private:
  void play_sound_file(Instant now);
  void toggle_mute(Instant now);
  void choose_device(const std::string& name, Instant now);

  Notices& notices_;
  playback::Playback* playback_ = nullptr;
  std::unique_ptr<sound::SoundTrack> track_;  ///< of the sound file; null: what plays brings it
  sound::SoundPlayer player_{nullptr};
  bool has_device_ = false;
  std::string device_;                ///< that was chosen; empty: the usual one
  std::vector<std::string> devices_;  ///< to choose from
  std::filesystem::path file_;        ///< that what plays was read from; empty: none
  SpokenText spoken_;
  bool shows_spoken_ = true;
  int volume_;
  bool muted_;
};

}  // namespace aucast::app
