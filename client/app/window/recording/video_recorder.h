#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "client/app/background_work.h"
#include "client/app/window/recording/session_video.h"
#include "client/gui/gui_model.h"
#include "client/sound/sound_player.h"
#include "client/view/image.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The video of what the window shows, from the key that begins it to the one that ends it.
/// Thread: the player's.
class VideoRecorder {
 public:
  /// The face as it is shown now, in pixels of the picture wanted.
  using Picture = std::function<Result<view::Image>(int width, int height)>;

  struct Hooks {
    /// A file that is not there yet, for a video of what is shown.
    std::function<Result<std::filesystem::path>()> new_file;
    /// What is heard goes there from now on; empty: nowhere.
    std::function<void(sound::SoundPlayer::Tap)> hear;
    /// How it stands, for the panel.
    std::function<void(gui::VideoView)> show;
  };
  explicit VideoRecorder(Hooks hooks) : hooks_(std::move(hooks)) {}
  VideoRecorder(const VideoRecorder&) = delete;
  VideoRecorder& operator=(const VideoRecorder&) = delete;

  [[nodiscard]] bool running() const { return video_ != nullptr; }
  /// Only when none is running. Failed while the one before is being completed.
  [[nodiscard]] Result<void> begin(int width, int height, Instant now);
  /// Adds a picture when the video lacks one at `now`. A video that fails is over.
  [[nodiscard]] Result<void> record(const Picture& picture, Instant now);
  /// The video that is running is over, and is completed on another thread. Returns a sentence for
  /// the user about it.
  [[nodiscard]] Result<std::string> end();
  [[nodiscard]] bool completing() const { return work_.running(); }
  /// What became of it, once: a sentence that says where it is.
  [[nodiscard]] std::optional<Result<std::string>> ended();
  /// Waits until it is completed.
  void wait() const { work_.wait(); }

 private:
  [[nodiscard]] Result<std::string> sentence(const Result<std::string>& outcome) const;
  std::unique_ptr<SessionVideo> let_go();
  void show();

  Hooks hooks_;
  std::filesystem::path file_;  ///< of the video that runs or ran last
  std::unique_ptr<SessionVideo> video_;
  BackgroundWork work_;
};

}  // namespace aucast::app
