#include "client/app/window/recording/session_video.h"

namespace aucast::app {

std::uint64_t pictures_due(Duration elapsed, int fps, std::uint64_t written) {
  if (elapsed < Duration::zero()) return 0;
  const auto whole = static_cast<std::uint64_t>(elapsed * fps / std::chrono::seconds(1)) + 1;
  return whole > written ? whole - written : 0;
}

Result<std::unique_ptr<SessionVideo>> SessionVideo::open(const std::filesystem::path& file,
                                                         int width, int height, Instant begin) {
  auto encoder = view::VideoEncoder::open(file, width, height, kFps);
  if (!encoder) return encoder.error();
  auto sound = VideoSound::open(file, begin);
  if (!sound) return sound.error();
  std::unique_ptr<SessionVideo> video(new SessionVideo(begin));
  video->width_ = width;
  video->height_ = height;
  video->encoder_ = std::move(*encoder);
  video->sound_ = std::move(*sound);
  return video;
}

bool SessionVideo::due(Instant now) {
  return pictures_due(time_.place_of(now), kFps, written_) > 0;
}

Result<void> SessionVideo::show(const view::Image& picture, Instant now) {
  for (std::uint64_t left = pictures_due(time_.place_of(now), kFps, written_); left > 0; --left) {
    if (auto added = encoder_->add(picture); !added) return added;
    ++written_;
  }
  return {};
}

Result<void> SessionVideo::finish() {
  const auto sound = sound_->file();
  if (!sound) return sound.error();
  return encoder_->finish(*sound);
}

}  // namespace aucast::app
