#include "client/app/window/recording/video_feed.h"

#include <algorithm>

#include "common/thread.h"

namespace aucast::app {

Result<std::unique_ptr<VideoFeed>> VideoFeed::start(const std::filesystem::path& file, int width,
                                                    int height, int fps, Milliseconds patience) {
  const std::size_t picture_bytes =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
  const std::size_t fit = kWaitingBytesMax / std::max<std::size_t>(picture_bytes, 1);
  std::unique_ptr<VideoFeed> feed(new VideoFeed(std::clamp<std::size_t>(fit, 1, kWaitingMax)));
  const auto over = [stop = feed->stop_.get_token()] { return stop.stop_requested(); };
  auto encoder = view::VideoEncoder::open(file, width, height, fps, over, patience);
  if (!encoder) return encoder.error();
  feed->encoder_ = *std::move(encoder);
  auto started = start_thread([&feed = *feed] { feed.run(); });
  if (!started) return started.error();
  feed->thread_ = std::move(*started);
  return feed;
}

VideoFeed::~VideoFeed() {
  course_.with([](Course& course) {
    course.abandoned = true;
    course.waiting.clear();
  });
  stop_.request_stop();
}

void VideoFeed::run() {
  const auto take = [](Course& course) -> std::optional<Waiting> {
    if (course.waiting.empty()) return std::nullopt;
    std::optional<Waiting> next(std::move(course.waiting.front()));
    course.waiting.pop_front();
    return next;
  };
  const auto something = [](const Course& course) { return !course.waiting.empty(); };
  while (const auto next = course_.wait(stop_.get_token(), something, take)) {
    if (auto fed = feed(*next); !fed) {
      return course_.with([&](Course& course) { course.failure = fed.error(); });
    }
  }
}

Result<void> VideoFeed::feed(const Waiting& next) {
  for (std::uint64_t left = next.times; left > 0; --left) {
    if (course_.with([](const Course& course) { return course.abandoned; })) break;
    if (auto added = encoder_->add(next.picture); !added) return added;
  }
  return {};
}

bool VideoFeed::repeat_newest(std::uint64_t times) {
  return course_.with([&](Course& course) {
    if (course.failure || course.waiting.size() < waiting_max_) return false;
    course.waiting.back().times += times;
    return true;
  });
}

Result<void> VideoFeed::add(view::Image picture, std::uint64_t times) {
  return course_.change([&](Course& course) -> Result<void> {
    if (course.failure) return *course.failure;
    course.waiting.push_back({std::move(picture), times});
    return {};
  });
}

Result<void> VideoFeed::finish(const std::filesystem::path& sound) {
  stop_.request_stop();
  thread_.join();
  // An encoder that has failed says again why.
  return encoder_->finish(sound);
}

}  // namespace aucast::app
