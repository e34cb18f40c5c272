#include "client/app/window/playing/sound_session.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "client/gui/texts/texts.h"
#include "client/sound/openal_out.h"
#include "common/log.h"
#include "common/overloaded.h"
#include "common/sound_name.h"

namespace aucast::app {

SoundSession::SoundSession(const SoundOptions& options, sound::HeardPlayer& player,
                           Notices& notices)
    : player_(player),
      notices_(notices),
      wanted_(!options.none),
      device_(options.device.value_or("default")),
      volume_(options.volume),
      muted_(options.mute) {
  if (device_ == "default") device_.clear();
  player_.sound().set_volume(volume_);
  player_.sound().set_muted(muted_);
}

void SoundSession::begin_again() {
  track_.reset();
  spoken_.begin_again();
  file_.clear();
}

void SoundSession::play_beside(const std::filesystem::path& file, Instant now) {
  file_ = file;
  if (const auto read = spoken_.read_beside(file); !read) {
    notices_.say(read.error().message, true, now);
  }
  play_sound_file(now);
}

void SoundSession::play_sound_file(Instant now) {
  if (!has_device_ || file_.empty() || track_ != nullptr) return;
  const auto sound = sound_beside(file_);
  if (!sound) return;
  auto track = sound::FileTrack::begin(*sound);
  if (!track) {
    notices_.say(track.error().message, true, now);
    return;
  }
  player_.sound().open(player_.playback(), track->get());
  track_ = std::move(*track);
}

Result<void> SoundSession::play_file(const std::filesystem::path& sound, const std::string& stream,
                                     Instant now) {
  if (!has_device_) {
    return Error{ErrorKind::Failed, gui::tr("said.not_heard", sound.filename().string())};
  }
  auto track = sound::FileTrack::begin(sound);
  if (!track) return track.error();
  player_.sound().open(player_.playback(), track->get());
  track_ = std::move(*track);
  notices_.say(gui::tr("said.sound_plays", sound.filename().string(), stream), false, now);
  return {};
}

void SoundSession::advanced(Instant now) {
  if (const auto place = player_.heard_place()) spoken_.move_to(*player_.playback(), *place);
  if (track_ != nullptr) {
    if (const auto complaint = track_->take_complaint(); !complaint.empty()) {
      spdlog::warn("{}", complaint);
    }
  }
  if (player_.sound().take_loss()) {
    has_device_ = false;
    missed_ = true;
    notices_.say(gui::tr("said.device_lost"), true, now);
    spdlog::warn("the sound device plays no more; going on without it");
  }
}

void SoundSession::set_out(std::unique_ptr<sound::SoundOut> out) {
  has_device_ = out != nullptr;
  missed_ = wanted_ && !has_device_;
  player_.sound().set_out(std::move(out));
}

void SoundSession::apply(const gui::SoundCommand& command, Instant now) {
  const Overloaded carry_out{
      [&](const gui::SetVolume& one) { change_volume(one.percent - volume_, now); },
      [&](const gui::ToggleMute&) { toggle_mute(now); },
      [&](const gui::ListDevices&) { devices_ = sound::sound_devices(); },
      [&](const gui::ChooseDevice& one) { choose_device(one.name, now); },
      [&](const gui::ToggleCaptions&) {
        shows_spoken_ = !shows_spoken_;
        notices_.say(gui::tr(shows_spoken_ ? gui::TextKey("said.captions")
                                           : gui::TextKey("said.no_captions")),
                     false, now);
      }};
  std::visit(carry_out, command);
}

/// Only one device may be open at a time, so the previous one is closed first.
void SoundSession::choose_device(const std::string& name, Instant now) {
  set_out(nullptr);
  auto out = sound::open_sound_device(name);
  if (!out) {
    notices_.say(out.error().message, true, now);
    out = sound::open_sound_device(device_);
    if (!out) return;
  } else {
    device_ = name;
  }
  set_out(std::move(*out));
  play_sound_file(now);
}

void SoundSession::toggle_mute(Instant now) {
  muted_ = !muted_;
  player_.sound().set_muted(muted_);
  notices_.say(muted_ ? std::string(gui::tr("said.muted")) : gui::tr("said.volume", volume_), false,
               now);
}

void SoundSession::set_volume(int percent) {
  volume_ = std::clamp(percent, 0, 100);
  player_.sound().set_volume(volume_);
}

void SoundSession::change_volume(int by, Instant now) {
  set_volume(volume_ + by);
  muted_ = false;
  player_.sound().set_muted(muted_);
  notices_.say(gui::tr("said.volume", volume_), false, now);
}

gui::SoundView SoundSession::sound_view() const {
  /// The range of the meter, in decibels.
  constexpr double kRange = 48;
  gui::SoundView view;
  view.there = has_device_;
  view.missed = missed_;
  view.volume = volume_;
  view.muted = muted_;
  if (const float peak = player_.sound().peak(); peak > 0) {
    const double part = 1 + 20 * std::log10(static_cast<double>(peak)) / kRange;
    view.peak_percent = static_cast<int>(std::lround(100 * std::clamp(part, 0.0, 1.0)));
  }
  view.device = device_;
  view.devices = devices_;
  return view;
}

gui::SpokenView SoundSession::spoken_view() const {
  return {spoken_.title(), spoken_.caption(), shows_spoken_};
}

}  // namespace aucast::app
