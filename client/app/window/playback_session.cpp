#include "client/app/window/playback_session.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/app/live_text.h"
#include "client/app/remote_options.h"
#include "client/app/steady.h"
#include "client/app/window/session_video.h"
#include "client/gui/kept_settings.h"
#include "client/gui/said_text.h"
#include "client/gui/texts.h"
#include "client/gui/view_text.h"
#include "client/net/remote_source.h"
#include "common/log.h"
#include "common/overloaded.h"
#include "common/text.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

using playback::PlaybackState;

/// Buffers and bytes change without anything moving: so often they are looked at.
constexpr Milliseconds kLookEvery{50};
constexpr Milliseconds kIdle{250};
constexpr Milliseconds kSoundStep{10};
constexpr Milliseconds kJustInTime{2};

}  // namespace

PlaybackSession::PlaybackSession(const pipeline::AuMapping& mapping, const PlayerOptions& options,
                                 PlayerStats& stats, Notices& notices,
                                 const std::vector<float>& shown)
    : mapping_(mapping),
      options_(options),
      stats_(stats),
      notices_(notices),
      shown_(shown),
      buffers_(options.playback.buffers),
      player_(mapping, options.playback.interpolation),
      meter_(stats),
      sound_(options.sound, player_, notices) {}

void PlaybackSession::set_remote(const gui::RemoteSettings& settings,
                                 std::vector<std::string> recent) {
  remote_settings_ = settings;
  worked_ = settings;
  recent_ = std::move(recent);
}

playback::SeekablePlayback* PlaybackSession::seekable() const {
  return playback_ == nullptr ? nullptr : playback_->seekable();
}

// === Playing.

void PlaybackSession::open(std::unique_ptr<playback::Playback> playback, std::string name,
                           Instant now) {
  if (running()) playback_->stop(player_.now(now));
  retired_ = std::exchange(playback_, std::move(playback));
  name_ = std::move(name);
  curves_.reset();
  if (const auto* whole = seekable()) {
    curves_ = std::make_shared<const gui::AuCurves>(gui::curves_of(whole->keyframes()));
  }
  player_.open(playback_.get(), shown_);
  sound_.begin_again();
  meter_.begin_again();
  explained_.clear();
  received_ = {};
  history_.clear();
  answered_ = false;
  timed_ = false;
  own_ = false;
}

void PlaybackSession::open(std::vector<playback::TimedAus> keyframes, std::string name,
                           Instant now) {
  const Milliseconds untimed = options_.playback.speed.value_or(protocol::kDefaultKeyframeTime);
  open(std::make_unique<playback::SeekablePlayback>(std::move(keyframes), untimed), std::move(name),
       now);
}

void PlaybackSession::watch_own(const net::Endpoint& endpoint, Instant now) {
  net::RemoteOptions remote = remote_options(options_.playback, endpoint);
  remote.others.clear();
  remote.stream.clear();
  remote.security = {};
  remote.reconnect = remote.voice = false;
  remote.buffers.low_delay = true;
  buffers_ = remote.buffers;
  const playback::SourcePlayback::Options how{remote.speed, options_.playback.hold, false};
  open(std::make_unique<playback::SourcePlayback>(
           std::make_unique<net::RemoteSource>(std::move(remote)), how),
       {}, now);
  answered_ = true;  // or it would be remembered
  own_ = true;
}

Result<net::RemoteOptions> PlaybackSession::server_of(const gui::RemoteSettings& settings) const {
  const PlaybackOptions& options = options_.playback;
  net::SecurityOptions protection = options.security_options;
  protection.tls |= settings.tls;
  if (!settings.token_file.empty()) protection.token = settings.token_file;
  auto security = net::load_security(protection, settings.address);
  if (!security) return security.error();
  const net::Endpoint asked{settings.address, static_cast<std::uint16_t>(settings.port)};
  net::RemoteOptions remote = remote_options(options, asked);
  remote.others = settings.others;
  remote.speed.reset();
  if (settings.speed_ms > 0) remote.speed = Milliseconds(settings.speed_ms);
  remote.reconnect = settings.reconnect || !remote.others.empty();
  remote.stream = settings.stream;
  // A device may have been plugged in, or chosen, since.
  remote.voice = options.voice || sound_.has_device();
  remote.captions = true;
  remote.security = *std::move(security);
  remote.buffers.receiver_capacity = static_cast<std::size_t>(settings.buffer);
  remote.buffers.playout_capacity = static_cast<std::size_t>(settings.playout);
  remote.buffers.threshold_percent = settings.threshold_percent;
  return remote;
}

bool PlaybackSession::connect(const gui::RemoteSettings& settings, Instant now) {
  if (gui::problem(settings)) return false;
  auto remote = server_of(settings);
  if (!remote) {
    notices_.say(remote.error().message, true, now);
    return false;
  }
  remote_settings_ = settings;
  buffers_ = remote->buffers;
  const playback::SourcePlayback::Options how{remote->speed, options_.playback.hold, false};
  open(std::make_unique<playback::SourcePlayback>(
           std::make_unique<net::RemoteSource>(*std::move(remote)), how),
       {}, now);
  return true;
}

void PlaybackSession::advance(Instant now) {
  now_ = now;
  if (playback_ == nullptr) return;
  const playback::SourceStatus before = playback_->status();
  if (std::exchange(tried_, before.reconnects) != before.reconnects) {
    again_at_ = now + before.retry_after;
  }
  const Instant at = player_.advance(
      now, [this](const playback::KeyframeBegun& one, Instant begin) { begun(one, begin); });
  sound_.advanced(now);
  if (meter_.advanced(*playback_, at) && seekable() == nullptr) {
    const LiveObjection objection = live_objection(options_.playback, playback_->status());
    if (objection != LiveObjection::None) {
      spdlog::warn("{}", terminal_text(objection));
      notices_.say(window_text(objection), false, now);
    }
  }
  remember(now);
  if (!answered_ && seekable() == nullptr && playback_->status().packets_received > 0) {
    answered_ = true;
    worked_ = remote_settings_;
    gui::remember_address(recent_, remote_settings_);
  }
}

void PlaybackSession::play_beside(const std::filesystem::path& file, Instant now) {
  if (!file.empty() && seekable() != nullptr) sound_.play_beside(file, now);
}

void PlaybackSession::begun(const playback::KeyframeBegun& keyframe, Instant at) {
  meter_.begun(*playback_, keyframe, at);
  explain();
  timed_ = keyframe.target.duration.has_value();
  // A file can be asked again; the easing to neutral was not received.
  if (seekable() != nullptr || playback_->eased()) return;
  received_.add({keyframe.target.aus, keyframe.duration});
}

void PlaybackSession::explain() {
  explained_ = face::explain(player_.face().pipeline().fired());
}

void PlaybackSession::remember(Instant now) {
  if (!running() || seekable() != nullptr || !history_.due(now)) return;
  const playback::SourceStatus status = playback_->status();
  const float fill = static_cast<float>(status.receiver_fill) /
                     static_cast<float>(std::max<std::size_t>(buffers_.receiver_capacity, 1));
  history_.add(now, fill, status, player_.face().face().aus);
}

void PlaybackSession::remake(playback::Interpolation interpolation) {
  player_.face().set_interpolation(interpolation);
  player_.face().remake();
  explain();
}

void PlaybackSession::change_face() {
  player_.change_face();
  explain();
}

std::unique_ptr<playback::Playback> PlaybackSession::finish(Instant now) {
  if (running()) playback_->stop(player_.now(now));
  if (playback_ != nullptr) stats_.take(*playback_);
  stats_.sound = player_.sound().counts();
  player_.open(nullptr, shown_);
  sound_.begin_again();
  return std::move(playback_);
}

Played PlaybackSession::played() const {
  const auto* whole = seekable();
  if (whole == nullptr) return received_;
  const auto& keyframes = whole->keyframes();
  return {{keyframes.begin(), keyframes.end()}, keyframes.size()};
}

// === What the panels ask for.

bool PlaybackSession::apply(const gui::PlaybackCommand& command, Instant now) {
  const Overloaded carry_out{
      [&](const gui::Connect& one) { return connect(one.settings, now); },
      [&](const gui::Pause&) {
        if (running()) playback_->pause(player_.now(now));
        return false;
      },
      [&](const gui::Resume&) { return resume(player_.now(now)); },
      [&](const gui::Stop&) {
        if (!running()) return false;
        if (seekable() != nullptr) {
          playback_->pause(player_.now(now));
        } else {
          playback_->stop(player_.now(now));
        }
        return false;
      },
      [&](const gui::LocalCommand& one) { return apply_local(one, player_.now(now)); }};
  return std::visit(carry_out, command);
}

bool PlaybackSession::resume(Instant now) {
  if (seekable() == nullptr && !running()) return false;
  playback_->resume(now);
  return true;
}

/// A step is a picture of what is made of the stream: of the window's videos, unless --fps says
/// what is exported.
int PlaybackSession::step_fps() const {
  return options_.output.fps.value_or(SessionVideo::kFps);
}

/// Said, because the bar with its button may be hidden when the key is pressed.
void PlaybackSession::toggle_repeat(playback::LocalPlayback& playhead, Instant now) {
  playhead.set_repeat(!playhead.repeats(), now);
  notices_.say(gui::tr(playhead.repeats() ? gui::TextKey("said.repeats")
                                          : gui::TextKey("said.repeats_no_more")),
               false, now);
}

bool PlaybackSession::apply_local(const gui::LocalCommand& command, Instant now) {
  auto* const whole = seekable();
  if (whole == nullptr) return false;
  playback::LocalPlayback& playhead = whole->playhead(now);
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
                               playhead.step_frame(one.direction, step_fps(), now);
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
  return std::visit(carry_out, command);
}

// === What the panels show.

bool PlaybackSession::stands() const {
  if (playback_ == nullptr) return false;
  if (seekable() != nullptr) return playback_->state() != PlaybackState::Playing;
  return playback_->state() == PlaybackState::Paused;
}

Duration PlaybackSession::idle_time(Instant now) const {
  if (playback_ == nullptr) return kIdle;
  // The device wants silence too.
  if (player_.sound().sounds()) return kSoundStep;
  if (const auto next = playback_->next_position_at()) {
    return std::clamp<Duration>(*next - now, Duration::zero(), kFrameMax);
  }
  if (!running() || playback_->seekable() != nullptr) return kIdle;
  if (!buffers_.low_delay) return kLookEvery;
  // Keyframes that come just in time are waited for between two positions.
  return playback_->state() == PlaybackState::Playing ? kJustInTime : kFrameMax;
}

std::string PlaybackSession::title() const {
  std::string title = "AUcast";
  if (playback_ == nullptr) return title;
  if (seekable() != nullptr) return name_ + " - " + title;
  const playback::SourceStatus status = playback_->status();
  title += " - " + gui::state_name(playback_->state());
  // What plays on from the buffers has not ended, whatever the server said.
  if (over() && !status.detail.empty()) title += ": " + gui::in_used_language(status.detail);
  return title;
}

void PlaybackSession::describe_traffic(const playback::SourceStatus& status,
                                       gui::RemoteView& view) const {
  const PlaybackHistory::Rates rates = running() ? history_.rates() : PlaybackHistory::Rates{};
  const PlaybackHistory::Rates means = history_.mean_rates();
  const std::string in = gui::traffic_text(status.bytes_received, rates.in, means.in);
  view.in = status.packets_received == 1 ? gui::tr("state.packet", in)
                                         : gui::tr("state.packets", status.packets_received, in);
  view.out = gui::traffic_text(status.bytes_sent, rates.out, means.out);
  view.protocol =
      gui::tr(status.negotiated ? gui::TextKey("state.level") : gui::TextKey("state.classic"));
  if (status.live) view.protocol = gui::tr("state.live", view.protocol);
}

std::vector<gui::AuRow> PlaybackSession::au_rows() const {
  if (playback_ == nullptr || playback_->progress().keyframe == 0) return {};
  const pipeline::FacePipeline& pipeline = player_.face().pipeline();
  return gui::au_rows(pipeline.received(), player_.face().face().aus, explained_,
                      mapping_.recordings);
}

gui::RemoteView PlaybackSession::remote_view() const {
  gui::RemoteView view;
  view.state = gui::tr("state.none");
  view.receiver.capacity = buffers_.receiver_capacity;
  view.receiver.threshold_percent = buffers_.threshold_percent;
  view.playout.capacity = buffers_.playout_capacity;
  if (playback_ == nullptr) return view;
  const playback::SourceStatus status = playback_->status();
  const PlaybackState state = playback_->state();
  view.activity = gui::activity_of(state, status);
  view.state = gui::state_in_words(state, status, buffers_);
  view.aus = au_rows();
  const std::uint64_t keyframe = playback_->progress().keyframe;
  if (keyframe > 0) view.keyframe = gui::tr("state.keyframe", keyframe);
  if (const auto* whole = seekable()) {
    view.local = true;
    if (keyframe > 0) {
      view.keyframe = gui::tr("state.keyframe_of", keyframe, whole->keyframes().size());
    }
    return view;
  }
  if (gui::plays_the_rest(state, status)) view.state = gui::tr("state.playing_rest");
  // Without an end a detail says why it is tried again.
  const bool tries_again =
      status.end == playback::EndReason::NotEnded && !status.connected && status.reconnects > 0;
  if (gui::went_wrong(status.end)) view.detail = gui::in_used_language(status.detail);
  if (tries_again) {
    view.detail = gui::in_used_language(status.reason);
    view.again_s = static_cast<int>(std::max<std::int64_t>(
        0, std::chrono::ceil<std::chrono::seconds>(again_at_ - now_).count()));
    view.tries_again = true;
  }
  const bool empty = status.receiver_fill + status.playout_fill == 0;
  view.stale = keyframe > 0 && (state == PlaybackState::Lost || (tries_again && empty));
  view.eased = playback_->eased();
  const bool ended =
      state == PlaybackState::Ended && status.end == playback::EndReason::EndOfStream;
  if (!own_) view.stream = status.stream;
  if (ended && !own_) view.ended_by = gui::server_text(remote_settings_);
  view.timed = timed_;
  view.receiver.fill = status.receiver_fill;
  view.playout.fill = status.playout_fill;
  view.receiver_history = history_.fills();
  view.au_history = history_.traces();
  if (status.connected || status.packets_received > 0) describe_traffic(status, view);
  view.delay = delay_text(playback_->delays().lately(), status.delay);
  return view;
}

gui::LocalView PlaybackSession::local_view() const {
  gui::LocalView view;
  const auto* const whole = seekable();
  if (whole == nullptr) return view;
  const playback::LocalPlayback& playhead = std::as_const(*whole).playhead();
  view.open = true;
  view.name = name_;
  view.playing = whole->state() == PlaybackState::Playing;
  view.position = whole->position();
  view.total = playhead.total();
  view.ends = whole->ends();
  view.keyframe = std::max<std::uint64_t>(whole->progress().keyframe, 1);
  view.speed_percent = playhead.speed_percent();
  view.loop_begin = playhead.loop_begin();
  view.loop_end = playhead.loop_end();
  view.repeats = playhead.repeats();
  view.step_fps = step_fps();
  view.curves = curves_;
  return view;
}

}  // namespace aucast::app
