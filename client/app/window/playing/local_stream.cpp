#include "client/app/window/playing/local_stream.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "client/app/window/recording/session_video.h"
#include "client/gui/texts/texts.h"
#include "common/overloaded.h"

namespace aucast::app {

using playback::PlaybackState;

LocalStream::LocalStream(std::unique_ptr<playback::SeekablePlayback> playback, std::string name,
                         std::optional<int> step_fps, Notices& notices)
    : playback_(std::move(playback)),
      name_(std::move(name)),
      step_fps_(step_fps),
      notices_(notices),
      curves_(std::make_shared<const gui::AuCurves>(gui::curves_of(playback_->keyframes()))) {}

void LocalStream::stop(Instant now) {
  playback_->pause(now);
  playback_->playhead(now).seek(Duration::zero(), now);
}

bool LocalStream::resume(Instant now) {
  playback_->resume(now);
  return true;
}

void LocalStream::step(playback::LocalPlayback& playhead, int direction, Instant now) const {
  if (!step_fps_ && playhead.picture_time()) return playhead.step_picture(direction, now);
  playhead.step_at_rate(direction, step_fps(), now);
}

int LocalStream::step_fps() const {
  if (step_fps_) return *step_fps_;
  const auto time = std::as_const(*playback_).playhead().picture_time();
  return time ? static_cast<int>(std::lround(1 / seconds(*time))) : SessionVideo::kFps;
}

/// Shows a notice, because the bar with its button may be hidden when the key is pressed.
void LocalStream::toggle_repeat(playback::LocalPlayback& playhead, Instant now) {
  playhead.set_repeat(!playhead.repeats(), now);
  notices_.say(gui::tr(playhead.repeats() ? gui::TextKey("said.repeats")
                                          : gui::TextKey("said.repeats_no_more")),
               false, now);
}

bool LocalStream::apply(const gui::LocalCommand& command, Instant now) {
  playback::LocalPlayback& playhead = playback_->playhead(now);
  const bool ended = playhead.over(now);
  const Overloaded carry_out{[&](const gui::Seek& one) {
                               playhead.seek(one.position, now);
                               return true;
                             },
                             [&](const gui::SeekBy& one) {
                               playhead.seek(playhead.position(now) + one.time, now);
                               return true;
                             },
                             [&](const gui::StepKeyframe& one) {
                               playhead.step_keyframe(one.direction, now);
                               return true;
                             },
                             [&](const gui::StepFrame& one) {
                               step(playhead, one.direction, now);
                               return true;
                             },
                             [&](const gui::SetSpeed& one) {
                               playhead.set_speed(one.percent, now);
                               return false;
                             },
                             [&](const gui::ChangeSpeed& one) {
                               playhead.change_speed(one.direction, now);
                               return false;
                             },
                             [&](const gui::MarkLoop&) {
                               playhead.mark_loop(now);
                               return false;
                             },
                             [&](const gui::ToggleRepeat&) {
                               toggle_repeat(playhead, now);
                               return false;
                             }};
  const bool shows = std::visit(carry_out, command);
  // Repeat and a loop begin anew what had ended.
  return shows || (ended && !playhead.over(now));
}

bool LocalStream::stands() const {
  return playback_->state() != PlaybackState::Playing;
}

Played LocalStream::played() const {
  const auto& keyframes = playback_->keyframes();
  return {keyframes, keyframes.size(), playback_->untimed()};
}

void LocalStream::describe(gui::PlayingView& view) const {
  view.local = true;
  const std::uint64_t keyframe = playback_->progress().keyframe;
  if (keyframe == 0) return;
  view.keyframe = gui::tr("state.keyframe_of", keyframe, playback_->keyframes().size());
}

gui::LocalView LocalStream::local_view() const {
  const playback::LocalPlayback& playhead = std::as_const(*playback_).playhead();
  gui::LocalView view;
  view.open = true;
  view.name = name_;
  view.playing = playback_->state() == PlaybackState::Playing;
  view.position = playback_->position();
  view.total = playhead.total();
  view.ends = playback_->ends();
  view.keyframe = std::max<std::uint64_t>(playback_->progress().keyframe, 1);
  view.speed_percent = playhead.speed_percent();
  view.loop_begin = playhead.loop_begin();
  view.loop_end = playhead.loop_end();
  view.repeats = playhead.repeats();
  view.step_fps = step_fps();
  view.curves = curves_;
  return view;
}

}  // namespace aucast::app
