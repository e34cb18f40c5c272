#pragma once

#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/steady.h"
#include "client/app/window/recording/video_recorder.h"
#include "client/app/window/window_display.h"
#include "client/app/window/window_session.h"

namespace aucast::app {

/// Pictures and videos of what the window shows. The user is told what became of them, in the
/// window and on standard error. The constructor's arguments must outlive it. Thread: the player's.
class WindowPictures {
 public:
  WindowPictures(WindowSession& session, WindowDisplay& display, const Assets& assets,
                 const OutputOptions& output)
      : session_(session), display_(display), assets_(assets), output_(output) {}

  [[nodiscard]] gui::VideoView video() const { return video_.view(); }
  /// How the face is drawn now.
  [[nodiscard]] view::Style style() const;
  /// Saves a picture. `activations`: those of the face that was drawn last.
  void save(const std::vector<float>& activations, Instant now);
  /// Begins a video, or ends the one that is running.
  void toggle_video(Instant now);
  /// Adds a picture to the running video if one is due. Tells the user when a video is completed.
  void advance(Instant now);
  /// How long advance() may wait.
  [[nodiscard]] Duration wait_max() const;
  /// Ends the video that is running, and waits until it is completed.
  void finish(Instant now);

 private:
  void size(int& width, int& height) const;
  void end_video(Instant now);
  void tell_of_video(Instant now);
  void tell(const std::string& sentence, Instant now);
  void complain(const Error& error, Instant now);

  WindowSession& session_;
  WindowDisplay& display_;
  const Assets& assets_;
  const OutputOptions& output_;
  VideoRecorder video_{
      {.new_file =
           [this] {
             return new_picture_file(session_.settings().pictures(), session_.named(), today(),
                                     ".mp4");
           },
       .hear = [this](sound::SoundPlayer::Tap tap) { session_.sound().set_tap(std::move(tap)); }}};
};

}  // namespace aucast::app
