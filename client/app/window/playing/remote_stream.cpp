#include "client/app/window/playing/remote_stream.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "client/app/live_text.h"
#include "client/gui/model/view_text.h"
#include "client/gui/texts/said_text.h"
#include "client/gui/texts/texts.h"

namespace aucast::app {
namespace {

using playback::EndReason;
using playback::PlaybackState;

/// How often the window looks at buffers and bytes, which change even if nothing moves.
constexpr Milliseconds kLookEvery{50};
constexpr Milliseconds kJustInTime{2};

/// If the stream has not ended, the detail says why it is tried again.
bool tries_again(const playback::SourceStatus& status) {
  return status.end == EndReason::NotEnded && !status.connected && status.reconnects > 0;
}

}  // namespace

RemoteStream::RemoteStream(std::unique_ptr<playback::Playback> playback,
                           const playback::BufferOptions& buffers, Server server)
    : playback_(std::move(playback)), buffers_(buffers), server_(server) {}

bool RemoteStream::take_answer() {
  if (server_ == Server::OwnCamera || playback_->status().keyframes_received == 0) return false;
  return !std::exchange(remembered_, true);
}

bool RemoteStream::ended_by_server() const {
  return server_ != Server::OwnCamera && playback_->state() == PlaybackState::Ended &&
         playback_->status().end == EndReason::EndOfStream;
}

/// Keeps every keyframe except the easing to neutral, which was not received.
void RemoteStream::begun(const playback::KeyframeBegun& keyframe) {
  timed_ = keyframe.target.time.has_value();
  if (!playback_->eased()) received_.add({keyframe.target.aus, keyframe.time});
}

void RemoteStream::advanced(Instant now, const AuFrame& aus) {
  now_ = now;
  const playback::SourceStatus status = playback_->status();
  if (std::exchange(tried_, status.reconnects) != status.reconnects) {
    again_at_ = now + status.retry_after;
  }
  if (!running() || !history_.due(now)) return;
  const float fill = static_cast<float>(status.receiver_fill) /
                     static_cast<float>(std::max<std::size_t>(buffers_.receiver_capacity, 1));
  history_.add(now, fill, status, aus);
}

bool RemoteStream::resume(Instant now) {
  if (!running()) return false;
  playback_->resume(now);
  return true;
}

bool RemoteStream::stands() const {
  return playback_->state() == PlaybackState::Paused;
}

/// With low delay it also looks for keyframes between two positions, because they come just in
/// time.
Duration RemoteStream::idle_time() const {
  if (!running()) return kIdle;
  if (!buffers_.low_delay) return kLookEvery;
  return playback_->state() == PlaybackState::Playing ? kJustInTime : kFrameMax;
}

std::string RemoteStream::title(const std::string& program, bool over) const {
  const playback::SourceStatus status = playback_->status();
  const PlaybackState state = playback_->state();
  const std::string connecting = gui::connecting_in_words(state, status);
  const std::string title =
      program + " - " + (connecting.empty() ? gui::state_name(state) : connecting);
  // What plays on from the buffers has not ended, whatever the server said.
  if (!over || status.detail.empty()) return title;
  return title + ": " + gui::in_used_language(status.detail);
}

void RemoteStream::describe(gui::PlayingView& view) const {
  const playback::SourceStatus status = playback_->status();
  const PlaybackState state = playback_->state();
  if (gui::plays_the_rest(state, status)) view.state = gui::tr("state.playing_rest");
  describe_trouble(status, view);
  view.eased = playback_->eased();
  if (server_ != Server::OwnCamera) view.stream = status.stream;
  view.timed = timed_;
  view.receiver.fill = status.receiver_fill;
  view.playout.fill = status.playout_fill;
  view.receiver_history = history_.fills();
  view.au_history = history_.traces();
  if (status.connected || status.keyframes_received > 0) describe_traffic(status, view);
  view.delay = delay_text(playback_->delays().lately(), status.delay);
}

void RemoteStream::describe_trouble(const playback::SourceStatus& status,
                                    gui::PlayingView& view) const {
  if (gui::went_wrong(status.end)) view.detail = gui::in_used_language(status.detail);
  view.tries_again = tries_again(status);
  if (view.tries_again) {
    view.detail = gui::in_used_language(status.reason);
    view.again_s = static_cast<int>(std::max<std::int64_t>(
        0, std::chrono::ceil<std::chrono::seconds>(again_at_ - now_).count()));
  }
  const bool empty = status.receiver_fill + status.playout_fill == 0;
  view.stale = playback_->progress().keyframe > 0 &&
               (playback_->state() == PlaybackState::Lost || (view.tries_again && empty));
}

void RemoteStream::describe_traffic(const playback::SourceStatus& status,
                                    gui::PlayingView& view) const {
  const PlaybackHistory::Rates rates = running() ? history_.rates() : PlaybackHistory::Rates{};
  const PlaybackHistory::Rates means = history_.mean_rates();
  const std::string in = gui::traffic_text(status.bytes_received, rates.in, means.in);
  view.in = status.keyframes_received == 1
                ? gui::tr("state.packet", in)
                : gui::tr("state.packets", status.keyframes_received, in);
  view.out = gui::traffic_text(status.bytes_sent, rates.out, means.out);
  view.protocol =
      gui::tr(status.negotiated ? gui::TextKey("state.level") : gui::TextKey("state.classic"));
  if (status.live) view.protocol = gui::tr("state.live", view.protocol);
  if (status.negotiated && status.keyframes_received > 0) view.live = status.live;
}

}  // namespace aucast::app
