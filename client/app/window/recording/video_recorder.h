#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "client/app/background_work.h"
#include "client/app/window/recording/session_video.h"
#include "client/gui/model/gui_model.h"
#include "client/sound/sound_player.h"
#include "client/view/image.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// Records a video of what the window shows, from the key that begins it to the key that ends it.
/// Thread: the player's.
class VideoRecorder {
 public:
  /// Makes a picture of the face as it is shown now; width and height in pixels.
  using Picture = std::function<Result<view::Image>(int width, int height)>;

  struct Hooks {
    /// Returns the path of a new file for a video.
    std::function<Result<std::filesystem::path>()> new_file;
    /// Sets where the sound that is heard goes; empty: nowhere.
    std::function<void(sound::SoundPlayer::Tap)> hear;
  };
  explicit VideoRecorder(Hooks hooks) : hooks_(std::move(hooks)) {}
  VideoRecorder(const VideoRecorder&) = delete;
  VideoRecorder& operator=(const VideoRecorder&) = delete;

  [[nodiscard]] gui::VideoView view() const;
  [[nodiscard]] bool running() const { return video_ != nullptr; }
  /// Begins a video. Must not be called while running(). Fails while the previous one is being
  /// completed.
  [[nodiscard]] Result<void> begin(int width, int height, Instant now);
  /// Adds a picture if the video lacks one at `now`. If that fails, the video ends.
  [[nodiscard]] Result<void> record(const Picture& picture, Instant now);
  /// Ends the video, which is then completed on another thread. Returns a sentence for the user.
  [[nodiscard]] Result<std::string> end();
  [[nodiscard]] bool completing() const { return work_.running(); }
  /// The result, once the video is completed: a sentence that says where it is.
  [[nodiscard]] std::optional<Result<std::string>> ended() { return work_.take_outcome(); }
  /// Waits until the video is completed.
  void wait() const { work_.wait(); }

 private:
  [[nodiscard]] std::string saved(const SessionVideo& video) const;
  std::unique_ptr<SessionVideo> let_go();

  Hooks hooks_;
  std::filesystem::path file_;  ///< the file of the running or, if none runs, the last video
  std::unique_ptr<SessionVideo> video_;
  BackgroundWork work_;
};

}  // namespace aucast::app
