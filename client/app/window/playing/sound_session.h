#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/app/notices.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/spoken_text.h"
#include "client/gui/gui_commands.h"
#include "client/sound/heard_player.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_player.h"
#include "client/sound/sound_track.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// What is heard and read beside the face that plays in the window: the device, how loud it is, the
/// voice or sound file, the captions; and what the panels show of them. What the constructor takes
/// must outlive it. Thread: the player's.
class SoundSession {
 public:
  SoundSession(const SoundOptions& options, sound::HeardPlayer& player, Notices& notices);

  /// The player plays something else from now on.
  void begin_again();
  /// What plays was read from this file: the sound file and the captions beside it, if there are
  /// any, belong to it.
  void play_beside(const std::filesystem::path& file, Instant now);
  /// This sound file is heard with what plays, called `stream`, in place of what else was; that is
  /// said. Its failures are those of a file; Failed without a device.
  [[nodiscard]] Result<void> play_file(const std::filesystem::path& sound,
                                       const std::string& stream, Instant now);
  /// The player has been advanced to `now`.
  void advanced(Instant now);

  /// It is heard there from now on; null: nowhere.
  void set_out(std::unique_ptr<sound::SoundOut> out);
  /// SoundPlayer's.
  void set_tap(sound::SoundPlayer::Tap tap) { player_.sound().set_tap(std::move(tap)); }
  /// There is a device.
  [[nodiscard]] bool has_device() const { return has_device_; }

  void apply(const gui::SoundCommand& command, Instant now);
  /// By so many percent.
  void change_volume(int by, Instant now);

  [[nodiscard]] gui::SoundView sound_view() const;
  [[nodiscard]] gui::SpokenView spoken_view() const;

 private:
  void play_sound_file(Instant now);
  void toggle_mute(Instant now);
  void choose_device(const std::string& name, Instant now);

  sound::HeardPlayer& player_;
  Notices& notices_;
  std::unique_ptr<sound::SoundTrack> track_;  ///< of the sound file; null: what plays brings it
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
