#include "client/app/window/window_session.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>

#include "client/app/steady.h"
#include "client/app/window/live_text.h"
#include "client/face/au_blender.h"
#include "client/gui/channel_groups.h"
#include "client/gui/user_face.h"
#include "client/gui/view_text.h"
#include "client/net/remote_source.h"
#include "client/playback/blinking.h"
#include "client/playback/file_source.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

using playback::PlaybackState;

/// An hour of a live stream at 25 a second.
constexpr std::size_t kKeyframesKept = 90'000;
/// Buffers and bytes change without anything moving: so often they are looked at.
constexpr Milliseconds kLookEvery{50};
constexpr Milliseconds kRest{250};
constexpr Milliseconds kFrameMax{20};
constexpr Milliseconds kJustInTime{2};
/// Of a stream that is there whole.
constexpr Milliseconds kLocalFrame{10};

bool went_wrong(playback::EndReason end) {
  using playback::EndReason;
  return end != EndReason::NotEnded && end != EndReason::EndOfStream && end != EndReason::Stopped;
}

gui::RemoteSettings settings_of(const PlaybackOptions& options) {
  gui::RemoteSettings settings;
  if (const auto endpoint = net::parse_endpoint(options.endpoint)) {
    settings.address = endpoint->host;
    settings.port = endpoint->port;
  }
  settings.buffer = static_cast<int>(options.buffers.receiver_capacity);
  settings.playout = static_cast<int>(options.buffers.playout_capacity);
  settings.threshold_percent = options.buffers.threshold_percent;
  if (options.speed) settings.speed_ms = static_cast<int>(options.speed->count());
  settings.reconnect = options.reconnect;
  return settings;
}

/// One for each expression, in their order.
std::vector<gui::ExpressionButton> buttons_of(const std::vector<Expression>& expressions) {
  using gui::ExpressionKind;
  std::vector<gui::ExpressionButton> buttons;
  for (const Expression& expression : expressions) {
    const auto same = [&](const gui::ExpressionButton& one) {
      return one.kind == ExpressionKind::Main && one.label == expression.label;
    };
    gui::ExpressionButton button{expression.label, protocol::format_au_set(expression.aus),
                                 ExpressionKind::Main};
    if (!expression.muscles.empty()) {
      button.kind = ExpressionKind::Macro;
      button.what = expression.source;
    } else if (std::any_of(buttons.begin(), buttons.end(), same)) {
      button.kind = ExpressionKind::Other;
      button.label = expression.name;
    }
    buttons.push_back(std::move(button));
  }
  return buttons;
}

std::vector<gui::PadPoint> pad_of(const std::vector<Expression>& expressions) {
  std::vector<gui::PadPoint> points;
  for (const Expression& expression : expressions) {
    if (!expression.pad) continue;
    points.push_back(
        {expression.label, (*expression.pad)[0], (*expression.pad)[1], expression.aus});
  }
  return points;
}

}  // namespace

WindowSession::WindowSession(const Assets& assets, const PlayerOptions& options,
                             std::unique_ptr<playback::KeyframeSource> source, PlayerStats& stats)
    : assets_(assets),
      options_(options),
      stats_(stats),
      face_(assets.face),
      rules_(assets.rules),
      animation_{options.face.mixer, options.face.rules, options.playback.interpolation},
      remote_settings_(settings_of(options.playback)),
      buffers_(options.playback.buffers),
      source_(std::move(source)),
      controller_(options.playback.speed),
      editor_(face_),
      idle_(face_),
      held_(face_.channels.size()),
      activations_(face_.channels.size()),
      face_now_(face_.channels.size()) {
  pipeline_.emplace(face_, rules_,
                    pipeline::PipelineOptions{animation_.mixer, animation_.interpolation});
  controller_.set_hold(options.playback.hold);
  buttons_ = buttons_of(assets.expressions);
  pad_ = std::make_shared<const std::vector<gui::PadPoint>>(pad_of(assets.expressions));
  show_composed();
  list_aus();
  rendering_.blinking = options.playback.blink.has_value();
  rendering_.blink = options.playback.blink.value_or(playback::BlinkOptions{});
  rendering_.layers = options.output.layers;
  if (const auto* file = dynamic_cast<const playback::FileSource*>(source_.get())) {
    play_local(options.playback.file.filename().string(), file->keyframes());
    if (options.playback.file.has_parent_path()) {
      last_folder_ = options.playback.file.parent_path();
    } else {
      last_folder_ = ".";
    }
  } else {
    last_folder_ = assets.data_folder / "streams";
  }
}

WindowSession::~WindowSession() = default;

void WindowSession::begin_with(const gui::KeptSettings& settings, const std::string& complaint,
                               Instant now) {
  if (!complaint.empty()) say(complaint, true, now);
  remote_settings_ = settings.remote;
  recent_ = settings.recent;
  transition_settings_ = settings.transition;
  rendering_ = settings.rendering;
}

gui::KeptSettings WindowSession::kept() const {
  return {remote_settings_, recent_, animation_, transition_settings_, rendering_};
}

// === Playing.

void WindowSession::begin_keyframe(const AuFrame& aus, double cut_at) {
  static_cast<void>(pipeline_->at(cut_at));
  aus_before_ = pipeline_->blended();
  pipeline_->begin_keyframe(aus);
  explain(aus);
}

/// What came and what the rules made of it, for the panel.
void WindowSession::explain(const AuFrame& aus) {
  std::vector<face::RuleFired> fired;
  const AuFrame blended = face::blend(rules_, aus, &fired);
  aus_ = gui::au_rows(aus, blended, face::explain(fired));
}

void WindowSession::advance(Instant now) {
  if (!notice_.text.empty() && now >= notice_until_) notice_ = {};
  if (source_ == nullptr) return;
  if (local_) return advance_local(now);
  const std::uint64_t played = controller_.keyframes_played();
  while (const auto begun = controller_.advance(now, *source_)) {
    trace_progress(now);
    begin_keyframe(begun->target.aus, begun->cut_at);
    // The easing to neutral was not received.
    if (!controller_.eased() && received_.size() < kKeyframesKept) {
      received_.push_back({begun->target.aus, static_cast<std::uint32_t>(begun->duration.count())});
    }
    if (!first_begin_) begin_stream(now);
  }
  trace_progress(now);
  if (controller_.keyframes_played() != played) {
    stats_.playback_seconds = seconds(now - *first_begin_);
  }
  remember(now);
}

void WindowSession::begin_stream(Instant now) {
  first_begin_ = now;
  const std::string objection = live_objection(options_.playback, source_->status());
  if (objection.empty()) return;
  spdlog::warn("{}", objection);
  say(objection, false, now);
}

/// A keyframe that was reached is still the pipeline's.
void WindowSession::trace_progress(Instant now) {
  if (std::exchange(traced_, controller_.keyframes_played()) == controller_.keyframes_played()) {
    return;
  }
  trace_reached(pipeline_->received(), now);
}

void WindowSession::remember(Instant now) {
  if (!running() || !history_.due(now)) return;
  const playback::SourceStatus status = source_->status();
  const float fill = static_cast<float>(status.receiver_fill) /
                     static_cast<float>(std::max<std::size_t>(buffers_.receiver_capacity, 1));
  AuFrame aus = pipeline_->blended();
  const float weight = playback::ease(animation_.interpolation, controller_.moment().mu);
  playback::interpolate(aus_before_.left, aus.left, weight, aus.left);
  playback::interpolate(aus_before_.right, aus.right, weight, aus.right);
  history_.add(now, fill, status, aus);
}

void WindowSession::toggle_pause(Instant now) {
  const bool stands = local_ ? !local_->moving() : controller_.state() == PlaybackState::Paused;
  if (stands) {
    carry_out(gui::Resume{}, now);
  } else {
    carry_out(gui::Pause{}, now);
  }
}

const std::vector<float>& WindowSession::activations(Instant now) {
  if (shown_ == Shown::Editor) {
    if (transition_ && transition_->over(now)) transition_.reset();
    face_now_ = transition_ ? transition_->at(now) : editor_.activations();
  } else if (shown_ == Shown::Composer) {
    face_now_ = composed_;
  } else if (local_) {
    face_now_ = pipeline_->at(local_->mu());
  } else if (controller_.moment().keyframe > 0) {
    face_now_ = pipeline_->at(controller_.moment().mu);
  } else {
    face_now_ = held_;
  }
  activations_ = face_now_;
  add_idle_life(now);
  return activations_;
}

void WindowSession::add_idle_life(Instant now) {
  const double at = std::chrono::duration<double>(now.time_since_epoch()).count();
  if (const auto& seed = options_.playback.idle_seed) {
    idle_.stir(playback::idle_moment(*seed, at), activations_);
  }
  if (rendering_.blinking) idle_.blink(playback::blink_closure(rendering_.blink, at), activations_);
}

Duration WindowSession::rest(Instant now) const {
  Duration rest = running() && !local_ ? kLookEvery : kRest;
  if (!notice_.text.empty()) rest = std::clamp<Duration>(notice_until_ - now, kFrameMax, rest);
  if (rendering_.blinking || options_.playback.idle_seed) rest = kFrameMax;
  const auto at_most = [&](std::optional<Instant> next) {
    if (next) rest = std::clamp<Duration>(*next - now, Duration::zero(), kFrameMax);
  };
  if (local_ && local_->moving()) {
    rest = kLocalFrame;
  } else if (shown_ == Shown::Playback) {
    at_most(controller_.next_position_at());
    if (options_.playback.buffers.low_delay && running() && !controller_.next_position_at()) {
      // Keyframes that come just in time are waited for between two positions.
      const bool waits = controller_.state() == PlaybackState::Playing;
      rest = std::min<Duration>(rest, waits ? kJustInTime : kFrameMax);
    }
  } else if (transition_) {
    at_most(transition_->next_frame_at(now));
  }
  return rest;
}

std::unique_ptr<playback::KeyframeSource> WindowSession::finish(Instant now) {
  if (running()) {
    source_->stop();
    controller_.stop(now);
  }
  if (local_) {
    stats_.keyframes_played = local_->playback().keyframes_played(now);
    stats_.media_seconds = seconds(local_->playback().media_time(now));
    while (local_->over() && source_->take()) {
      // So that the source says that it was played to its end.
    }
    return std::move(source_);
  }
  stats_.take(controller_);
  return std::move(source_);
}

// === What the panels ask for.

void WindowSession::apply(const gui::GuiCommand& command, Instant now) {
  std::visit([&](const auto& one) { carry_out(one, now); }, command);
}

void WindowSession::carry_out(const gui::Connect& command, Instant now) {
  if (gui::problem(command.settings)) return;
  remote_settings_ = command.settings;
  gui::remember_address(recent_, remote_settings_);
  buffers_.receiver_capacity = static_cast<std::size_t>(remote_settings_.buffer);
  buffers_.playout_capacity = static_cast<std::size_t>(remote_settings_.playout);
  buffers_.threshold_percent = remote_settings_.threshold_percent;
  net::RemoteOptions remote;
  remote.host = remote_settings_.address;
  remote.port = static_cast<std::uint16_t>(remote_settings_.port);
  remote.classic = options_.playback.classic;
  remote.stream = options_.playback.stream;
  remote.connect_timeout = options_.playback.connect_timeout;
  std::optional<Milliseconds> speed;
  if (remote_settings_.speed_ms > 0) speed = Milliseconds(remote_settings_.speed_ms);
  remote.speed = speed;
  remote.reconnect = remote_settings_.reconnect;
  remote.security = options_.playback.security;
  remote.buffers = buffers_;
  replace_source(std::make_unique<net::RemoteSource>(std::move(remote)), speed, now);
}

/// Something else plays from now on; until it begins the face stays as it is.
void WindowSession::replace_source(std::unique_ptr<playback::KeyframeSource> source,
                                   std::optional<Milliseconds> speed, Instant now) {
  carry_out(gui::Stop{}, now);
  static_cast<void>(activations(now));
  held_ = face_now_;
  retired_.clear();
  if (source_) retired_.push_back(std::move(source_));
  source_ = std::move(source);
  local_.reset();
  received_.clear();
  local_played_ = 0;
  traced_ = 0;
  shown_ = Shown::Playback;
  transition_.reset();
  controller_ = playback::PlaybackController(speed);
  controller_.set_hold(options_.playback.hold);
  pipeline_.emplace(face_, rules_,
                    pipeline::PipelineOptions{animation_.mixer, animation_.interpolation});
  first_begin_.reset();
  aus_.clear();
  history_.clear();
}

void WindowSession::carry_out(const gui::Pause&, Instant now) {
  if (!running()) return;
  if (local_) return local_->pause(now);
  controller_.pause(now);
  if (auto* remote = dynamic_cast<net::RemoteSource*>(source_.get())) remote->pause();
}

void WindowSession::carry_out(const gui::Resume&, Instant now) {
  if (local_) {
    local_->play(now);
    shown_ = Shown::Playback;
    return;
  }
  if (!running()) return;
  controller_.resume(now);
  shown_ = Shown::Playback;
  if (auto* remote = dynamic_cast<net::RemoteSource*>(source_.get())) remote->resume();
}

void WindowSession::carry_out(const gui::Stop&, Instant now) {
  if (!running()) return;
  if (local_) return local_->pause(now);
  source_->stop();
  controller_.stop(now);
}

void WindowSession::carry_out(const gui::ChangeAnimation& command, Instant) {
  if (command.settings.rules != animation_.rules) {
    auto rules = face::find_rules(command.settings.rules, assets_.data_folder);
    if (!rules) {
      spdlog::error("{}", rules.error().message);
      return;
    }
    rules_ = std::move(*rules);
  }
  animation_ = command.settings;
  pipeline_->set_options({animation_.mixer, animation_.interpolation});
  show_composed();
  // A face that stands is made anew, so that the change is seen at once.
  if (local_) {
    local_->begin(*pipeline_);
    explain(pipeline_->received());
  } else if (over() && controller_.moment().mu >= 1) {
    begin_keyframe(pipeline_->received());
  }
}

void WindowSession::carry_out(const gui::ShowExpression& command, Instant now) {
  if (command.index >= assets_.expressions.size()) return;
  std::vector<float> target(face_.channels.size());
  const Expression& expression = assets_.expressions[command.index];
  face::mix(face_, face::blend(rules_, expression.aus), animation_.mixer, target);
  if (const auto set = apply_muscles(face_, expression, target); !set) {
    say(set.error().message, true, now);
    return;
  }
  take_slowly(std::move(target), now);
}

void WindowSession::carry_out(const gui::ChangeTransition& command, Instant) {
  transition_settings_ = command.settings;
}

/// The expression panel takes the face; what plays waits.
void WindowSession::edit(Instant now) {
  carry_out(gui::Pause{}, now);
  shown_ = Shown::Editor;
  transition_.reset();
  compound_.clear();
}

void WindowSession::carry_out(const gui::SetChannel& command, Instant now) {
  if (command.channel < 0 || static_cast<std::size_t>(command.channel) >= face_.channels.size()) {
    return;
  }
  edit(now);
  editor_.set(static_cast<std::size_t>(command.channel), command.value, command.continued);
}

void WindowSession::carry_out(const gui::SetLinked& command, Instant) {
  editor_.set_linked(command.linked);
}

void WindowSession::carry_out(const gui::LoadAu& command, Instant now) {
  edit(now);
  editor_.load(command.number);
}

void WindowSession::carry_out(const gui::SaveAu& command, Instant) {
  const Result<std::string> saved = save_recording(command.number);
  save_failed_ = !saved;
  saved_to_ = saved ? *saved : saved.error().message;
}

/// Returns a sentence about where it went.
Result<std::string> WindowSession::save_recording(int number) {
  auto faces = gui::user_faces_folder(std::getenv("XDG_DATA_HOME"), std::getenv("HOME"));
  if (!faces) return faces.error();
  auto folder = gui::writable_face(assets_.face_folder, *faces);
  if (!folder) return folder.error();
  const std::vector<float>& activations = editor_.activations();
  auto file = gui::save_au(*folder, number, gui::drive_of(face_, activations));
  if (!file) return file.error();
  face::AuRecording& recording = face_.recordings[number];
  recording.number = number;
  recording.activation = activations;
  editor_.saved(number);
  list_aus();
  return "AU" + std::to_string(number) + " saved in " + file->string() + "; use it with --face " +
         folder->string();
}

void WindowSession::carry_out(const gui::ShowAus& command, Instant now) {
  const auto aus = protocol::parse_au_set(command.aus);
  if (!aus) return say(aus.error().message, true, now);
  std::vector<face::RuleFired> fired;
  const AuFrame blended = face::blend(rules_, *aus, &fired);
  std::vector<float> target(face_.channels.size());
  face::mix(face_, blended, animation_.mixer, target);
  take_slowly(std::move(target), now);
  compound_ = gui::au_rows(*aus, blended, face::explain(fired));
}

/// The editor takes a face, on the way from the one that is shown.
void WindowSession::take_slowly(std::vector<float> target, Instant now) {
  static_cast<void>(activations(now));
  std::vector<float> start = face_now_;
  edit(now);
  editor_.take(target);
  transition_.emplace(std::move(start), std::move(target), transition_settings_, now);
}

void WindowSession::carry_out(const gui::RevertAu&, Instant now) {
  edit(now);
  editor_.revert();
}

void WindowSession::carry_out(const gui::NeutralFace&, Instant now) {
  edit(now);
  editor_.neutral();
}

void WindowSession::carry_out(const gui::Undo&, Instant now) {
  edit(now);
  editor_.undo();
}

void WindowSession::carry_out(const gui::Redo&, Instant now) {
  edit(now);
  editor_.redo();
}

void WindowSession::carry_out(const gui::ChangeRendering& command, Instant) {
  rendering_ = command.settings;
}

void WindowSession::carry_out(const gui::Leave& command, Instant) {
  asks_to_leave_ = false;
  leaving_ = command.really;
}

void WindowSession::ask_to_leave() {
  // Asking twice is an answer.
  leaving_ = asks_to_leave_ || !(editor_.unsaved() || composer_.unsaved());
  asks_to_leave_ = !leaving_;
}

// === What the panels show.

std::string WindowSession::title() const {
  std::string title = "AUcast";
  if (source_ == nullptr) return title;
  if (local_) return local_->name() + " - " + title;
  const playback::SourceStatus status = source_->status();
  title += " - " + std::string(playback::name(controller_.state()));
  // What plays on from the buffers has not ended, whatever the server said.
  if (over() && !status.detail.empty()) title += ": " + status.detail;
  return title;
}

void WindowSession::describe_traffic(const playback::SourceStatus& status,
                                     gui::RemoteView& view) const {
  const PlaybackHistory::Rates rates = running() ? history_.rates() : PlaybackHistory::Rates{};
  const PlaybackHistory::Rates means = history_.mean_rates();
  view.in = counted(status.packets_received, "packet") + ", " +
            gui::traffic_text(status.bytes_received, rates.in, means.in);
  view.out = gui::traffic_text(status.bytes_sent, rates.out, means.out);
  view.protocol = status.negotiated ? "level 2" : "classic";
  if (status.live) view.protocol += ", live";
}

gui::RemoteView WindowSession::remote_view() const {
  gui::RemoteView view;
  view.state = "no connection";
  view.receiver.capacity = buffers_.receiver_capacity;
  view.receiver.threshold_percent = buffers_.threshold_percent;
  view.playout.capacity = buffers_.playout_capacity;
  if (source_ == nullptr) return view;
  if (local_) {
    local_->describe(view);
    view.aus = aus_;
    return view;
  }
  const playback::SourceStatus status = source_->status();
  const PlaybackState state = controller_.state();
  view.activity = gui::activity_of(state, status);
  view.state = gui::state_in_words(state, status, buffers_);
  // Without an end a detail says why it is tried again.
  const bool tries_again =
      status.end == playback::EndReason::NotEnded && !status.connected && status.reconnects > 0;
  if (went_wrong(status.end) || tries_again) view.detail = status.detail;
  const bool none_left = state == PlaybackState::Lost || (tries_again && !source_->ready());
  view.stale = none_left && controller_.moment().keyframe > 0 && shown_ == Shown::Playback;
  view.eased = controller_.eased() && shown_ == Shown::Playback;
  view.local = dynamic_cast<const net::RemoteSource*>(source_.get()) == nullptr;
  view.receiver.fill = status.receiver_fill;
  view.playout.fill = status.playout_fill;
  if (!view.local) {
    view.receiver_history = history_.fills();
    view.au_history = history_.traces();
    if (status.connected || status.packets_received > 0) describe_traffic(status, view);
  }
  view.delay = delay_text(controller_.delays().lately(), status.delay);
  const std::uint64_t keyframe = controller_.moment().keyframe;
  if (keyframe > 0) view.keyframe = "keyframe " + std::to_string(keyframe);
  view.aus = aus_;
  return view;
}

gui::EditorView WindowSession::editor_view() const {
  gui::EditorView view;
  view.active = shown_ == Shown::Editor;
  view.groups = gui::channel_groups(face_, editor_.activations());
  view.linked = editor_.linked();
  view.au = editor_.au().value_or(-1);
  view.unsaved = editor_.unsaved();
  view.can_undo = editor_.can_undo();
  view.can_redo = editor_.can_redo();
  view.saved_to = saved_to_;
  view.save_failed = save_failed_;
  view.compound = compound_;
  return view;
}

gui::GuiModel WindowSession::model() const {
  gui::GuiModel model;
  model.remote_settings = remote_settings_;
  model.recent = recent_;
  model.remote = remote_view();
  if (local_) model.local = local_->view();
  model.browser = browser_.view();
  model.notice = notice_;
  model.animation = animation_;
  model.editor = editor_view();
  model.composer = composer_view();
  model.known_aus = known_aus_;
  model.recording = recording_;
  model.expressions = buttons_;
  model.transition = transition_settings_;
  model.rendering.settings = rendering_;
  model.rendering.pace = pace_;
  model.asks_to_leave = asks_to_leave_;
  return model;
}

}  // namespace aucast::app
