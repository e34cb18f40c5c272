#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/app/video/face_view.h"
#include "client/net/stream_question.h"
#include "client/pipeline/au_mapping.h"
#include "client/pipeline/hair_swing.h"
#include "client/playback/caption_line.h"
#include "client/playback/playback.h"
#include "client/sound/heard_player.h"
#include "client/view/image.h"
#include "client/view/scene.h"
#include "client/view/style.h"
#include "client/web/begun_keyframes.h"
#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::web {

/// The player in a browser: a face that shows a set of AUs, or plays a stream of a server over
/// WebSockets. It does not know the canvas: it draws into the framebuffer that is bound, and needs
/// a current WebGL 2 context as long as it lives.
/// Thread: the page's.
class Page {
 public:
  /// Reads data/faces/`face_name` and data/rules/facs.toml from the page's file system. The face is
  /// drawn neutral until make_more() has returned true.
  [[nodiscard]] static Result<std::unique_ptr<Page>> create(const std::string& face_name);
  /// Prepares what the face needs to move, a few milliseconds' worth per call so that the page
  /// never blocks. Returns true when everything is ready.
  bool make_more() { return view_->make_more(); }
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Stops what plays and shows these AUs, written as on the command line: `6,12:80`. Anything else
  /// is a Usage error, which names the column.
  [[nodiscard]] Result<void> show(std::string_view aus);
  /// Sets what is drawn of the face, as face-player's --show. An unknown word is a Usage error.
  [[nodiscard]] Result<void> set_layers(std::string_view layers);

  struct Wanted {
    std::string server;  ///< its name in messages
    std::string stream;  ///< empty: the server's first
    std::string token;   ///< empty: none
    bool voice = false;  ///< ask for the stream's voice; needs a decoder
  };
  void play(const Wanted& wanted);
  void stop();
  void pause(bool paused);
  /// What plays or has played; null: nothing.
  [[nodiscard]] const playback::Playback* playback() const { return playback_.get(); }
  /// The state as seen and heard: Ended only when the sound has ended too. Nullopt if nothing
  /// plays.
  [[nodiscard]] std::optional<playback::PlaybackState> state() const;
  /// Moves face and sound to the present. Returns true if the face differs from the one drawn last.
  /// Call it about every 20 ms while there is sound.
  bool advance();
  /// The AUs that the face shows, as they came, before the rules.
  [[nodiscard]] const AuFrame& aus() const { return aus_; }
  /// The keyframes that the face began since the last call, as lines of a stream file; of more than
  /// BegunKeyframes::kMax the newest.
  [[nodiscard]] std::vector<std::string> take_begun() { return begun_.take_lines(); }
  /// The caption to be shown now, UTF-8; empty: none.
  [[nodiscard]] const std::string& caption() const { return captions_.text(); }

  /// Says whether the browser allows the page to play sound. Initially it does not.
  void set_sound(bool on);
  [[nodiscard]] sound::SoundPlayer& sound() { return player_.sound(); }

  /// Asks the server for its streams. The answer appears in streams().
  void ask_streams(const std::string& server, const std::string& token);
  [[nodiscard]] const std::optional<Result<protocol::StreamList>>& streams() const {
    return streams_;
  }

  [[nodiscard]] view::Viewpoint& viewpoint() { return viewpoint_; }
  void draw(int width, int height);
  /// The face as `face-player pose --png` draws it; with the same graphics driver the bytes are the
  /// same. Afterwards the canvas's framebuffer is bound.
  [[nodiscard]] Result<view::Image> picture(int width, int height);
  /// Call it after the canvas has lost its context and got a new one. Makes everything in the
  /// context again; as after create(), make_more() must follow.
  [[nodiscard]] Result<void> renew();

 private:
  Page(face::Face face, face::RuleSet rules);
  [[nodiscard]] Result<void> make_view();
  void begun(const playback::KeyframeBegun& keyframe, Instant at);
  void show_what_is_heard();
  void swing_hair(Instant now);
  void pose();

  const face::Face face_;
  const pipeline::AuMapping mapping_;
  std::unique_ptr<app::FaceView> view_;
  sound::HeardPlayer player_;
  std::unique_ptr<playback::Playback> playback_;
  playback::CaptionLine captions_;
  BegunKeyframes begun_;
  AuFrame aus_;
  std::vector<float> wanted_;  ///< the activations to be drawn
  std::vector<float> posed_;   ///< the activations that the view has
  pipeline::HairSwing hair_;
  face::HairSway wanted_hair_;
  face::HairSway posed_hair_;
  std::unique_ptr<net::StreamQuestion> question_;
  std::optional<Result<protocol::StreamList>> streams_;
  view::Viewpoint viewpoint_;
  view::Style style_;
};

}  // namespace aucast::web
