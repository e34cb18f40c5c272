#include "client/app/window/video_recorder.h"

#include <span>
#include <utility>

namespace aucast::app {

Result<void> VideoRecorder::begin(int width, int height, Instant now) {
  const auto file = session_.picture_file(".mp4");
  if (!file) return file.error();
  auto video = SessionVideo::open(*file, width, height, now);
  if (!video) return video.error();
  video_ = std::move(*video);
  session_.set_recording(video_->file().filename().string());
  session_.set_sound_tap([this](Instant heard_at, std::span<const float> samples) {
    video_->hear(heard_at, samples);
  });
  return {};
}

Result<void> VideoRecorder::record(const Picture& picture, Instant now) {
  if (!running() || !video_->due(now)) return {};
  const auto image = picture(video_->width(), video_->height());
  const auto shown = image ? video_->show(*image, now) : Result<void>(image.error());
  if (!shown) let_go();
  return shown;
}

Result<std::string> VideoRecorder::end() {
  return let_go()->finish();
}

/// The session knows of no video any more.
std::unique_ptr<SessionVideo> VideoRecorder::let_go() {
  session_.set_sound_tap({});
  session_.set_recording({});
  return std::move(video_);
}

}  // namespace aucast::app
