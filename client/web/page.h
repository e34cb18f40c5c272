#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/app/film/face_view.h"
#include "client/net/stream_question.h"
#include "client/pipeline/au_mapping.h"
#include "client/playback/caption_line.h"
#include "client/playback/playback.h"
#include "client/sound/heard_player.h"
#include "client/view/image.h"
#include "client/view/scene.h"
#include "client/view/style.h"
#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::web {

/// A face on a canvas: what the player is in a window, in a browser. It shows a set of AUs, or
/// plays a stream of a server over WebSockets. Knows no canvas: it draws into the framebuffer that
/// is bound, and needs a current WebGL 2 context for all its life.
/// Thread: the page's.
class Page {
 public:
  /// Reads data/faces/`face_name` and data/rules/facs.toml of the page's file system. Draws the
  /// face at rest until make_more() has come to its end.
  [[nodiscard]] static Result<std::unique_ptr<Page>> create(const std::string& face_name);
  /// Makes the next few milliseconds' worth of what the face needs to move, so that a page never
  /// blocks. True when there is nothing left to make.
  bool make_more() { return view_->make_more(); }
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Shows these AUs from now on: `6,12:80`, as on the command line. Ends what plays. Usage error,
  /// with the column, for anything else.
  [[nodiscard]] Result<void> show(std::string_view aus);
  /// What is drawn of the face, as face-player's --show. Usage error for another word.
  [[nodiscard]] Result<void> set_layers(std::string_view layers);

  struct Wanted {
    std::string server;  ///< what messages call it
    std::string stream;  ///< empty: the server's first
    std::string token;   ///< empty: none
    bool voice = false;  ///< with its voice, which somebody can decode
  };
  void play(const Wanted& wanted);
  void stop();
  void pause(bool paused);
  /// Null: nothing was played.
  [[nodiscard]] const playback::Playback* playback() const { return playback_.get(); }
  /// Of what is seen and heard: Ended when the sound has ended, too. Nothing when nothing plays.
  [[nodiscard]] std::optional<playback::PlaybackState> state() const;
  /// Moves face and sound to the present; true when the face differs from the one drawn last. To be
  /// called about every 20 ms while there is sound.
  bool advance();
  /// The AUs of the face as they came, before the rules.
  [[nodiscard]] const AuFrame& aus() const { return aus_; }
  /// The keyframes that the face began since the last call, as lines of a stream file.
  [[nodiscard]] std::vector<std::string> take_begun();
  /// What is being said, in UTF-8; empty: nothing.
  [[nodiscard]] const std::string& caption() const { return captions_.text(); }

  /// Whether the browser allows the page to play sound; at first it does not.
  void set_sound(bool on);
  [[nodiscard]] sound::SoundPlayer& sound() { return player_.sound(); }

  /// Asks the server for its streams; streams() has the answer once there is one.
  void ask_streams(const std::string& server, const std::string& token);
  [[nodiscard]] const std::optional<Result<protocol::StreamList>>& streams() const {
    return streams_;
  }

  [[nodiscard]] view::Viewpoint& viewpoint() { return viewpoint_; }
  void draw(int width, int height);
  /// The face as `face-player pose --png` draws it, byte for byte on the same graphics driver.
  /// Unbinds its framebuffer.
  [[nodiscard]] Result<view::Image> picture(int width, int height);
  /// Call after the canvas has lost its context and got a new one: makes all that was in it again,
  /// as after create().
  [[nodiscard]] Result<void> renew();

 private:
  Page(face::Face face, face::RuleSet rules);
  [[nodiscard]] Result<void> make_view();
  void begun(const playback::KeyframeBegun& keyframe, Instant at);
  void show_what_is_heard();
  void pose();

  /// A keyframe that playback has begun, and when.
  struct Begun {
    Instant at;
    AuFrame aus;
    std::string line;
  };

  const face::Face face_;
  const pipeline::AuMapping mapping_;
  std::unique_ptr<app::FaceView> view_;
  sound::HeardPlayer player_;
  std::unique_ptr<playback::Playback> playback_;
  playback::CaptionLine captions_;
  std::deque<Begun> ahead_;  ///< what is begun, but neither heard nor seen yet
  AuFrame aus_;
  std::vector<float> wanted_;  ///< the activations to be drawn
  std::vector<float> posed_;   ///< those that the view has
  std::vector<std::string> begun_;
  std::unique_ptr<net::StreamQuestion> question_;
  std::optional<Result<protocol::StreamList>> streams_;
  view::Viewpoint viewpoint_;
  view::Style style_;
};

}  // namespace aucast::web
