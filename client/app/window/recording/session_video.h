#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "client/app/window/recording/video_feed.h"
#include "client/app/window/recording/video_sound.h"
#include "client/app/window/recording/video_time.h"
#include "client/view/image.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// How many pictures are missing in a video that began `elapsed` ago and has `written` pictures.
/// They are missing because a window is drawn irregularly, but a video has equally spaced pictures.
[[nodiscard]] std::uint64_t pictures_due(Duration elapsed, int fps, std::uint64_t written);

/// A video of what the window shows, with the sound that is heard, made in real time.
class SessionVideo {
 public:
  static constexpr int kFps = 25;

  [[nodiscard]] static Result<std::unique_ptr<SessionVideo>> open(const std::filesystem::path& file,
                                                                  int width, int height,
                                                                  Instant begin);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Whether the video lacks a picture at `now`. If the encoder is so slow that its
  /// queue is full, the newest picture in it is repeated instead.
  [[nodiscard]] bool wants_picture(Instant now);
  /// Adds the picture once for each one that is missing at `now`; after a stall, for at most
  /// VideoTime::kGapMax. Never waits for the encoder. Does nothing if no picture is missing.
  [[nodiscard]] Result<void> show(view::Image picture, Instant now);
  /// How many pictures only repeat the one before because the encoder was too slow.
  [[nodiscard]] std::uint64_t repeated() const { return repeated_; }
  /// See VideoSound::cut().
  [[nodiscard]] bool sound_cut() const { return sound_->cut(); }
  /// See VideoSound::add().
  void hear(Instant heard_at, std::span<const float> samples) {
    sound_->add(begin_ + time_.place_of(heard_at), samples);
  }
  /// Completes the file, which takes a while. May be called on any thread.
  [[nodiscard]] Result<void> finish();

 private:
  explicit SessionVideo(Instant begin) : begin_(begin), time_(begin) {}

  int width_ = 0;
  int height_ = 0;
  Instant begin_;
  VideoTime time_;
  std::uint64_t written_ = 0;
  std::uint64_t repeated_ = 0;
  std::unique_ptr<VideoFeed> feed_;
  std::unique_ptr<VideoSound> sound_;
};

}  // namespace aucast::app
