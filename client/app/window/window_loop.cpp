#include "client/app/window/window_loop.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/app/steady.h"
#include "client/app/window/playing/playing_stream.h"
#include "client/app/window/window_model.h"
#include "common/log.h"
#include "common/overloaded.h"

namespace aucast::app {

WindowLoop::WindowLoop(const Parts& parts)
    : parts_(parts),
      session_(parts.session),
      display_(parts.display),
      pictures_(parts.session, parts.display, parts.assets, parts.options.output),
      pace_(parts.now()),
      shown_face_(session_.faces().changes()),
      kept_addresses_(session_.playback().servers().recent()),
      kept_files_(session_.files().recent()),
      kept_face_(session_.faces().changes()) {}

void WindowLoop::tick(bool stopped_from_outside) {
  display_.poll(wait_max());
  leaving_ |= stopped_from_outside;
  if (display_.take_closing()) session_.ask_to_leave();
  for (std::string file = display_.next_dropped(); !file.empty(); file = display_.next_dropped()) {
    carry_out(gui::OpenStream{file});
  }
  if (failed_) return;
  session_.advance(now());
  keep_recent();
  show_title();
  if (display_.make_thumbnails(
          [this](const auto& aus) { return session_.composer().face_of(aus); })) {
    changed();
  }
  draw();
  if (picture_due_) take_picture();
  pictures_.advance(now());
  handle_keys();
  for (const gui::GuiCommand& command : commands_) carry_out(command);
  commands_.clear();
}

bool WindowLoop::done() const {
  return failed_ || leaving_ || session_.leaving().leaves() ||
         (parts_.options.exit_at_end && session_.playback().over());
}

Result<void> WindowLoop::outcome() const {
  return failed_ ? Result<void>(*failed_) : Result<void>();
}

void WindowLoop::finish() {
  keep_settings();
  if (picture_due_ && !failed_) {
    draw();
    take_picture();
  }
  pictures_.finish(now());
}

Duration WindowLoop::wait_max() const {
  if (frames_due_ > 0) return Duration::zero();
  Duration wait = std::min(session_.idle_time(now()), pictures_.wait_max());
  if (const auto at = display_.redraws_at(now())) wait = std::min(wait, *at - now());
  if (display_.thumbnails_wait()) wait = std::min<Duration>(wait, kFrameMax);
  return wait;
}

// === What the user asks for.

void WindowLoop::handle_keys() {
  const Overloaded carry_out_one{
      [&](const gui::GuiCommand& command) { carry_out(command); }, [&](WindowAct one) { act(one); },
      [&](SessionAct one) { (session_.*one)(now()); },
      [&](ChangeVolume by) { session_.sound().change_volume(by.percent, now()); }};
  for (render::Key key = display_.next_key(); key != render::Key::None; key = display_.next_key()) {
    changed();
    if (const KeyMeaning* meaning = meaning_of(key)) std::visit(carry_out_one, *meaning);
    show_new_face();
  }
}

void WindowLoop::act(WindowAct act) {
  if (act == WindowAct::Leave) return session_.ask_to_leave();
  if (act != WindowAct::CloseNearest) return display_.act(act, now());
  const gui::GuiCommands left = display_.close_nearest(shown_model_, now());
  for (const gui::GuiCommand& command : left) carry_out(command);
}

void WindowLoop::carry_out(const gui::GuiCommand& command) {
  if (failed_) return;
  changed();
  if (const auto* look = std::get_if<gui::LookFrom>(&command)) display_.look_from(look->view);
  picture_due_ |= std::holds_alternative<gui::TakePicture>(command);
  if (std::holds_alternative<gui::ToggleVideo>(command)) pictures_.toggle_video(now());
  session_.apply(command, now());
  show_new_face();
}

/// A key may have changed what is shown since it was drawn: a picture is taken when face, AUs and
/// name are of one moment.
void WindowLoop::take_picture() {
  picture_due_ = false;
  pictures_.save(shown_activations_, now());
}

/// What was made of the last face cannot show another one.
void WindowLoop::show_new_face() {
  if (std::exchange(shown_face_, session_.faces().changes()) == session_.faces().changes()) return;
  if (auto shown = display_.change_face(); !shown) {
    failed_ = shown.error();
    return;
  }
  shown_activations_.clear();
}

// === What is remembered.

/// An address, a file and a face are worth remembering even if the machine goes down.
void WindowLoop::keep_recent() {
  if (session_.faces().changes() == kept_face_ &&
      session_.playback().servers().recent() == kept_addresses_ &&
      session_.files().recent() == kept_files_) {
    return;
  }
  kept_face_ = session_.faces().changes();
  kept_addresses_ = session_.playback().servers().recent();
  kept_files_ = session_.files().recent();
  keep_settings();
}

void WindowLoop::keep_settings() {
  if (const auto kept = parts_.settings.keep(session_.kept()); !kept) {
    spdlog::warn("settings: {}", kept.error().message);
  }
}

// === What is shown.

void WindowLoop::show_title() {
  std::string title = session_.playback().title();
  if (title == title_) return;
  title_ = std::move(title);
  display_.set_title(title_);
}

/// Draws if something differs from what is shown.
void WindowLoop::draw() {
  const Instant begin = now();
  const std::vector<float>& activations = session_.face().activations(begin);
  const Duration mix = now() - begin;
  gui::GuiModel model = model_of(session_);
  if (model.display.language != shown_model_.display.language) pace_rows_.clear();
  model.rendering.pace = pace_rows_;
  model.video = pictures_.video();
  const bool moved = activations != shown_activations_;
  if (display_.take_redraw(now())) changed();
  frames_due_ = std::max(frames_due_, gui::frames_due(shown_model_, model));
  // Hair that swings on is drawn, but it is no other face.
  const bool swung = std::exchange(shown_hair_, session_.face().hair()) != session_.face().hair();
  if (!moved && !swung && frames_due_ == 0) return;
  frames_due_ = std::max(0, frames_due_ - 1);
  if (moved) shown_activations_ = activations;
  FrameTimes times = display_.draw(shown_activations_, shown_hair_, moved || swung,
                                   pictures_.style(), model, commands_);
  times.mix = mix;
  shown_model_ = std::move(model);
  if (display_.input_waits()) changed();
  count_frame(times, moved, now());
}

void WindowLoop::count_frame(const FrameTimes& times, bool moved, Instant end) {
  session_.face_shown(end, moved);
  spdlog::trace("drawn at {:.6f}", seconds(end.time_since_epoch()));
  PlayerStats& stats = parts_.stats;
  if (stats.frames_drawn++ == 0) {
    stats.first_frame_ms = since_start_ms();
    parts_.start_times.passed("picture");
    spdlog::debug("{}", parts_.start_times.text());
  }
  stats.draw_seconds += seconds(times.deform + times.face + times.panels);
  // Only frames in which the face moved count, or showing the pace would be a reason to draw.
  if (!moved) return;
  if (auto pace = pace_.add(times, end)) pace_rows_ = std::move(*pace);
}

}  // namespace aucast::app
