#include "client/app/window/local_stream.h"

#include <utility>
#include <variant>

#include "common/files.h"
#include "protocol/stream_file.h"

namespace aucast::app {
namespace {

std::vector<Milliseconds> times_of(const std::vector<playback::TimedAus>& keyframes,
                                   Milliseconds untimed) {
  std::vector<Milliseconds> times;
  times.reserve(keyframes.size());
  for (const playback::TimedAus& keyframe : keyframes) {
    times.push_back(keyframe.duration.value_or(untimed));
  }
  return times;
}

void carry_out(playback::LocalPlayback& playback, const gui::Seek& command, Instant now) {
  playback.seek(command.position, now);
}

void carry_out(playback::LocalPlayback& playback, const gui::StepKeyframe& command, Instant now) {
  playback.step_keyframe(command.direction, now);
}

void carry_out(playback::LocalPlayback& playback, const gui::StepFrame& command, Instant now) {
  playback.step_frame(command.direction, now);
}

void carry_out(playback::LocalPlayback& playback, const gui::SetSpeed& command, Instant now) {
  playback.set_speed(command.percent, now);
}

void carry_out(playback::LocalPlayback& playback, const gui::ChangeSpeed& command, Instant now) {
  playback.change_speed(command.direction, now);
}

void carry_out(playback::LocalPlayback& playback, const gui::MarkLoop&, Instant now) {
  playback.mark_loop(now);
}

}  // namespace

Result<std::vector<playback::TimedAus>> read_stream(const std::filesystem::path& file) {
  auto text = read_file(file);
  if (!text) return text.error();
  auto stream = protocol::parse_stream_file(*text, file.string());
  if (!stream) return stream.error();
  std::vector<playback::TimedAus> keyframes;
  for (const protocol::Keyframe& keyframe : stream->keyframes) {
    playback::TimedAus timed{frame_from_terms(keyframe.terms), std::nullopt};
    if (keyframe.duration_ms) timed.duration = Milliseconds(*keyframe.duration_ms);
    keyframes.push_back(timed);
  }
  return keyframes;
}

LocalStream::LocalStream(std::string name, std::vector<playback::TimedAus> keyframes,
                         Milliseconds untimed)
    : name_(std::move(name)),
      keyframes_(std::move(keyframes)),
      playback_(times_of(keyframes_, untimed)),
      ends_(std::make_shared<const std::vector<Duration>>(playback_.ends())) {}

void LocalStream::apply(const gui::LocalCommand& command, Instant now) {
  if (fresh_) play(now);
  std::visit([&](const auto& one) { carry_out(playback_, one, now); }, command);
}

void LocalStream::play(Instant now) {
  fresh_ = false;
  playback_.play(now);
}

void LocalStream::pause(Instant now) {
  fresh_ = false;
  playback_.pause(now);
}

void LocalStream::rewind(Instant now) {
  pause(now);
  playback_.seek(Duration::zero(), now);
}

bool LocalStream::advance(Instant now) {
  if (fresh_) play(now);
  position_ = playback_.position(now);
  over_ = playback_.over(now);
  const playback::StreamPlace before = std::exchange(place_, playback_.place(position_));
  return !std::exchange(begun_, true) || before.keyframe != place_.keyframe;
}

void LocalStream::begin(pipeline::FacePipeline& pipeline) const {
  // The face at the end of a keyframe does not depend on those before it.
  pipeline.begin_keyframe(place_.keyframe == 0 ? AuFrame{} : keyframes_[place_.keyframe - 1].aus);
  static_cast<void>(pipeline.at(1));
  pipeline.begin_keyframe(keyframes_[place_.keyframe].aus);
}

gui::LocalView LocalStream::view() const {
  gui::LocalView view;
  view.open = true;
  view.name = name_;
  view.playing = moving();
  view.position = position_;
  view.total = playback_.total();
  view.ends = ends_;
  view.keyframe = place_.keyframe + 1;
  view.speed_percent = playback_.speed_percent();
  view.loop_begin = playback_.loop_begin();
  view.loop_end = playback_.loop_end();
  return view;
}

void LocalStream::describe(gui::RemoteView& view) const {
  view.local = true;
  view.activity = over_      ? gui::Activity::Over
                  : moving() ? gui::Activity::Playing
                             : gui::Activity::Paused;
  view.state = over_ ? "ended" : moving() ? "playing" : "paused";
  view.keyframe = "keyframe " + std::to_string(place_.keyframe + 1) + " of " +
                  std::to_string(keyframes_.size());
}

}  // namespace aucast::app
