#pragma once

#include <functional>
#include <memory>
#include <string>

#include "client/app/window/session_video.h"
#include "client/app/window/window_session.h"
#include "client/view/image.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The video of what the window shows, from the key that begins it to the one that ends it: asks
/// the session for a file and for what is heard, and lets its panel know. The session must outlive
/// it. Thread: the player's.
class VideoRecorder {
 public:
  /// The face as it is shown now, in pixels of the picture wanted.
  using Picture = std::function<Result<view::Image>(int width, int height)>;

  explicit VideoRecorder(WindowSession& session) : session_(session) {}
  VideoRecorder(const VideoRecorder&) = delete;
  VideoRecorder& operator=(const VideoRecorder&) = delete;

  [[nodiscard]] bool running() const { return video_ != nullptr; }
  /// Only when none is running.
  [[nodiscard]] Result<void> begin(int width, int height, Instant now);
  /// Adds a picture when the video lacks one at `now`. A video that fails is over.
  [[nodiscard]] Result<void> record(const Picture& picture, Instant now);
  /// Completes the video that is running. Returns a sentence for the user that says where it is.
  [[nodiscard]] Result<std::string> end();

 private:
  std::unique_ptr<SessionVideo> let_go();

  WindowSession& session_;
  std::unique_ptr<SessionVideo> video_;
};

}  // namespace aucast::app
