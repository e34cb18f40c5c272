#include "client/app/window/playing/playback_session.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "client/app/live_text.h"
#include "client/app/remote_options.h"
#include "client/app/window/playing/local_stream.h"
#include "client/gui/model/view_text.h"
#include "client/gui/texts/texts.h"
#include "client/playback/seekable_playback.h"
#include "client/playback/source_playback.h"
#include "common/log.h"
#include "common/overloaded.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

constexpr Milliseconds kSoundStep{10};

}  // namespace

PlaybackSession::PlaybackSession(const pipeline::AuMapping& mapping, const PlayerOptions& options,
                                 PlayerStats& stats, Notices& notices,
                                 const std::vector<float>& shown)
    : mapping_(mapping),
      options_(options),
      stats_(stats),
      notices_(notices),
      shown_(shown),
      servers_(options.playback),
      buffers_(options.playback.buffers),
      player_(mapping, options.playback.interpolation),
      meter_(stats),
      sound_(options.sound, player_, notices) {}

// === Playing.

/// With --fps, a step by frame is a picture of what is exported.
std::unique_ptr<PlayingStream> PlaybackSession::stream_of(
    std::unique_ptr<playback::Playback> playback, std::string name) {
  if (playback == nullptr) return nullptr;
  if (playback->seekable() == nullptr) {
    return std::make_unique<RemoteStream>(std::move(playback), buffers_,
                                          RemoteStream::Server::Chosen);
  }
  std::unique_ptr<playback::SeekablePlayback> whole(playback.release()->seekable());
  return std::make_unique<LocalStream>(std::move(whole), std::move(name), options_.output.fps,
                                       notices_);
}

void PlaybackSession::begin(std::unique_ptr<PlayingStream> stream, Instant now) {
  if (running()) stream_->playback().stop(player_.now(now));
  retired_ = std::exchange(stream_, std::move(stream));
  player_.open(stream_ == nullptr ? nullptr : &stream_->playback(), shown_);
  sound_.begin_again();
  meter_.begin_again();
  explained_.clear();
  notices_.clear();  // what went wrong before is over
}

void PlaybackSession::open(std::unique_ptr<playback::Playback> playback, std::string name,
                           Instant now) {
  begin(stream_of(std::move(playback), std::move(name)), now);
}

void PlaybackSession::open(playback::KeyframeList keyframes, std::string name, Instant now) {
  const Milliseconds untimed = options_.playback.speed.value_or(protocol::kDefaultKeyframeTime);
  open(std::make_unique<playback::SeekablePlayback>(std::move(keyframes), untimed), std::move(name),
       now);
}

void PlaybackSession::open_remote(net::RemoteOptions options, RemoteStream::Server server,
                                  Instant now) {
  buffers_ = options.buffers;
  const playback::SourcePlayback::Options how{options.speed, options_.playback.hold, false};
  auto playback = std::make_unique<playback::SourcePlayback>(
      std::make_unique<net::RemoteSource>(std::move(options)), how);
  begin(std::make_unique<RemoteStream>(std::move(playback), buffers_, server), now);
}

void PlaybackSession::watch_own(const net::Endpoint& endpoint, std::string token, Instant now) {
  net::Security security;
  security.token = std::move(token);
  net::RemoteOptions remote = remote_options(options_.playback, endpoint, std::move(security));
  remote.others.clear();
  remote.stream.clear();
  remote.reconnect = remote.voice = false;
  remote.buffers.low_delay = true;
  open_remote(std::move(remote), RemoteStream::Server::OwnCamera, now);
}

bool PlaybackSession::connect(const gui::RemoteSettings& settings, Instant now) {
  if (gui::problem(settings)) return false;
  auto remote = server_of(settings);
  if (!remote) {
    notices_.say(remote.error().message, true, now);
    return false;
  }
  servers_.choose(settings);
  open_remote(*std::move(remote), RemoteStream::Server::Chosen, now);
  return true;
}

void PlaybackSession::advance(Instant now) {
  if (stream_ == nullptr) return;
  const Instant at = player_.advance(
      now, [this](const playback::KeyframeBegun& one, Instant begin) { begun(one, begin); });
  sound_.advanced(now);
  if (meter_.count(stream_->playback(), at)) object(now);
  stream_->advanced(now, player_.face().face().aus);
  if (stream_->take_answer()) servers_.answered();
}

void PlaybackSession::object(Instant now) {
  const LiveObjection objection = stream_->objection(options_.playback);
  if (objection == LiveObjection::None) return;
  spdlog::warn("{}", terminal_text(objection));
  notices_.say(window_text(objection), false, now);
}

void PlaybackSession::play_beside(const std::filesystem::path& file, Instant now) {
  if (!file.empty() && local_view().open) sound_.play_beside(file, now);
}

void PlaybackSession::begun(const playback::KeyframeBegun& keyframe, Instant at) {
  meter_.keyframe_begun(stream_->playback(), keyframe, at);
  const std::string missing = missing_.look_at(mapping_, keyframe.target.aus);
  if (!missing.empty()) spdlog::warn("{}", missing);
  explain();
  stream_->begun(keyframe);
}

void PlaybackSession::explain() {
  explained_ = face::explain(player_.face().pipeline().fired());
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
  if (running()) stream_->playback().stop(player_.now(now));
  if (stream_ != nullptr) stats_.take(stream_->playback());
  stats_.sound = player_.sound().counts();
  player_.open(nullptr, shown_);
  sound_.begin_again();
  return stream_ == nullptr ? nullptr : std::exchange(stream_, nullptr)->hand_out();
}

Played PlaybackSession::played() const {
  return stream_ == nullptr ? Played() : stream_->played();
}

// === What the panels ask for.

bool PlaybackSession::apply(const gui::PlaybackCommand& command, Instant now) {
  const Overloaded carry_out{
      [&](const gui::Connect& one) { return connect(one.settings, now); },
      [&](const gui::Pause&) {
        if (running()) stream_->playback().pause(player_.now(now));
        return false;
      },
      [&](const gui::Resume&) { return stream_ != nullptr && stream_->resume(player_.now(now)); },
      [&](const gui::Stop&) {
        if (running()) stream_->stop(player_.now(now));
        return false;
      },
      [&](const gui::LocalCommand& one) {
        return stream_ != nullptr && stream_->apply(one, player_.now(now));
      }};
  return std::visit(carry_out, command);
}

// === What the panels show.

std::uint64_t PlaybackSession::reached() const {
  if (stream_ == nullptr) return 0;
  const playback::PlaybackProgress progress = stream_->playback().progress();
  const bool under_way = progress.keyframe != 0 && progress.mu < 1;
  return progress.keyframe - (under_way ? 1 : 0);
}

Duration PlaybackSession::idle_time(Instant now) const {
  if (stream_ == nullptr) return PlayingStream::kIdle;
  // The device wants silence too.
  if (player_.sound().sounds()) return kSoundStep;
  if (const auto next = stream_->playback().next_position_at()) {
    return std::clamp<Duration>(*next - now, Duration::zero(), kFrameMax);
  }
  return stream_->idle_time();
}

std::string PlaybackSession::title() const {
  const std::string title = "AUcast";
  if (stream_ == nullptr) return title;
  const std::string whole = stream_->title(title, over());
  if (!stream_->of_chosen_server()) return whole;
  const gui::RemoteSettings& from = servers_.settings();
  const std::string stream = from.stream.empty() ? "" : "/" + from.stream;
  return gui::server_text(from) + stream + " - " + whole;
}

std::vector<gui::AuRow> PlaybackSession::au_rows() const {
  if (keyframe() == 0) return {};
  const pipeline::FacePipeline& pipeline = player_.face().pipeline();
  return gui::au_rows(pipeline.received(), player_.face().face().aus, explained_,
                      mapping_.recordings);
}

gui::PlayingView PlaybackSession::playing_view() const {
  gui::PlayingView view;
  view.state = gui::tr("state.none");
  view.receiver.capacity = buffers_.receiver_capacity;
  if (!buffers_.by_time) view.receiver.threshold_percent = buffers_.threshold_percent;
  view.playout.capacity = buffers_.playout_capacity;
  if (stream_ == nullptr) return view;
  const playback::SourceStatus status = stream_->playback().status();
  const playback::PlaybackState state = stream_->playback().state();
  if (status.live) view.receiver.threshold_percent = 0;  // a delay is waited for, not sets
  view.activity = gui::activity_of(state, status);
  view.state = gui::state_in_words(state, status, buffers_);
  view.aus = au_rows();
  if (keyframe() > 0) view.keyframe = gui::tr("state.keyframe", keyframe());
  stream_->describe(view);
  if (stream_->ended_by_server()) view.ended_by = gui::server_text(servers_.settings());
  return view;
}

}  // namespace aucast::app
