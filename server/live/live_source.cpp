#include "server/live/live_source.h"

#include <string>
#include <string_view>
#include <utility>

#include "common/log.h"
#include "server/streams/source_path.h"

namespace aucast::server {

LiveSource::LiveSource(asio::io_context& io, const LiveSourceOptions& options,
                       LiveStreams::Events events, Clock clock)
    : clock_(std::move(clock)),
      streams_(options.streams, std::move(events)),
      input_(io, options.streams.each.path, options.streams.follow,
             {[this](std::string_view bytes) {
                streams_.feed(bytes, clock_());
                say_what_is_lost();
                go_on();
              },
              [this] {
                streams_.caught_up(clock_());
                go_on();
              },
              [this] { on_end(); }, [this](const std::string& why) { streams_.begin_anew(why); }},
             opener(options)),
      timer_(io) {
  if (options.voice.empty()) return;
  voice_.emplace(io, options.voice, false,
                 LiveInput::Events{[this](std::string_view bytes) {
                                     streams_.feed_voice(bytes, clock_());
                                     go_on();
                                   },
                                   [] {},
                                   [this] {
                                     streams_.end_voice(clock_());
                                     go_on();
                                   },
                                   [](const std::string&) {}});
}

/// A camera's rows come through a pipe; everything else is opened by its path.
LiveInput::Opener LiveSource::opener(const LiveSourceOptions& options) {
  const auto device = camera_device(options.streams.each.path);
  if (!device) return {};
  camera::CameraOptions asked = options.camera;
  asked.device = *device;
  return [this, asked, faces = options.faces, on_sight = options.on_sight,
          given_up = options.given_up]() -> Result<Descriptor> {
    auto camera = camera::CameraFeed::start(asked, faces, on_sight, given_up);
    if (!camera) return camera.error();
    camera_ = std::move(*camera);
    return camera_->take_rows();
  };
}

/// Said once: it lasts for as long as this computer is too slow.
void LiveSource::say_what_is_lost() {
  if (!camera_ || loss_said_ || camera_->rows_left_out() == 0) return;
  loss_said_ = true;
  spdlog::warn("the camera's faces are not taken as fast as they are read; some are left out");
}

void LiveSource::on_end() {
  if (camera_) {
    const std::string why = camera_->complaint();
    spdlog::warn("the camera gives no more pictures{}", why.empty() ? "" : "; ffmpeg says: " + why);
    if (const auto lost = camera_->rows_left_out(); lost > 0) {
      spdlog::warn("{} of the camera's faces were left out", lost);
    }
  }
  streams_.end_input(clock_(), input_.ended());
  go_on();
}

Result<void> LiveSource::start() {
  if (auto opened = input_.start(); !opened) return opened;
  if (auto recorded = streams_.start(); !recorded) return recorded;
  if (voice_) {
    if (auto opened = voice_->start(); !opened) return opened;
  }
  if (!input_.has_past()) streams_.caught_up(clock_());
  return {};
}

void LiveSource::stop() {
  stopped_ = true;
  timer_.cancel();
  input_.stop();
  if (voice_) voice_->stop();
}

Result<void> LiveSource::finish() {
  if (auto recorded = streams_.finish_record(); !recorded) return recorded;
  if (input_.failure()) return *input_.failure();
  if (voice_ && voice_->failure()) return *voice_->failure();
  if (streams_.over() && streams_.nothing_came()) {
    return Error{ErrorKind::BadData,
                 streams_.served().front().name + ": the source ended before a keyframe came"};
  }
  return {};
}

/// Reads on if there is room, and sets the timer for what is due next.
void LiveSource::go_on() {
  if (stopped_) return;
  input_.set_reading(!streams_.full());
  const auto next = streams_.next();
  if (!next) {
    timer_.cancel();
    return;
  }
  timer_.after(*next - clock_(), [this] {
    streams_.advance(clock_());
    go_on();
  });
}

}  // namespace aucast::server
