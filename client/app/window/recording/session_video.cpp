#include "client/app/window/recording/session_video.h"

#include <utility>

namespace aucast::app {

std::uint64_t pictures_due(Duration elapsed, int fps, std::uint64_t written) {
  if (elapsed < Duration::zero()) return 0;
  const auto whole = static_cast<std::uint64_t>(elapsed * fps / std::chrono::seconds(1)) + 1;
  return whole > written ? whole - written : 0;
}

Result<std::unique_ptr<SessionVideo>> SessionVideo::open(const std::filesystem::path& file,
                                                         int width, int height, Instant begin) {
  auto feed = VideoFeed::start(file, width, height, kFps);
  if (!feed) return feed.error();
  auto sound = VideoSound::open(file, begin);
  if (!sound) return sound.error();
  std::unique_ptr<SessionVideo> video(new SessionVideo(begin));
  video->width_ = width;
  video->height_ = height;
  video->feed_ = std::move(*feed);
  video->sound_ = std::move(*sound);
  return video;
}

bool SessionVideo::wants_picture(Instant now) {
  const std::uint64_t missing = pictures_due(time_.place_of(now), kFps, written_);
  if (missing == 0 || !feed_->repeat_newest(missing)) return missing > 0;
  written_ += missing;
  repeated_ += missing;
  return false;
}

Result<void> SessionVideo::show(view::Image picture, Instant now) {
  const std::uint64_t missing = pictures_due(time_.place_of(now), kFps, written_);
  if (missing == 0) return {};
  written_ += missing;
  return feed_->add(std::move(picture), missing);
}

Result<void> SessionVideo::finish() {
  const auto sound = sound_->file();
  if (!sound) return sound.error();
  return feed_->finish(*sound);
}

}  // namespace aucast::app
