#pragma once

#include <memory>
#include <string>
#include <utility>

#include "client/app/live_text.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/played.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/model/stream_view.h"
#include "client/playback/playback.h"
#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::app {

/// The longest that the window waits while something moves.
inline constexpr Milliseconds kFrameMax{20};

/// What plays in the window, and what the panels show of it. There are two kinds: a RemoteStream is
/// a server's, a LocalStream is available whole. The times handed in are those of the player's
/// clock.
/// Thread: the player's.
class PlayingStream {
 public:
  /// The longest that the window waits while the stream does not move.
  static constexpr Milliseconds kIdle{250};

  PlayingStream() = default;
  virtual ~PlayingStream() = default;
  PlayingStream(const PlayingStream&) = delete;
  PlayingStream& operator=(const PlayingStream&) = delete;

  [[nodiscard]] virtual playback::Playback& playback() = 0;
  [[nodiscard]] virtual const playback::Playback& playback() const = 0;
  [[nodiscard]] bool running() const { return !playback().over(); }
  /// Hands out what plays. After that this object may only be destroyed.
  [[nodiscard]] virtual std::unique_ptr<playback::Playback> hand_out() = 0;

  /// Call it when this keyframe has begun.
  virtual void begun(const playback::KeyframeBegun& /*keyframe*/) {}
  /// Call it when playing has been advanced. `now`: by the steady clock; `aus`: those of the face.
  virtual void advanced(Instant /*now*/, const AuFrame& /*aus*/) {}

  /// Returns true a single time: at the first call after a keyframe has come from a server that the
  /// window should remember.
  [[nodiscard]] virtual bool take_answer() { return false; }
  /// Why --live has no effect on this stream.
  [[nodiscard]] virtual LiveObjection objection(const PlaybackOptions& /*options*/) const {
    return LiveObjection::None;
  }

  /// Carries out Stop while the stream runs.
  virtual void stop(Instant now) = 0;
  /// Plays on. Returns false if the stream cannot.
  virtual bool resume(Instant now) = 0;
  /// Carries out commands that only a LocalStream knows. Returns true if the window should now show
  /// the face of this stream, as after a seek or a step, or when a stream that had ended plays
  /// again.
  virtual bool apply(const gui::LocalCommand& /*command*/, Instant /*now*/) { return false; }

  /// Whether the face does not move and resume() would make it move.
  [[nodiscard]] virtual bool stands() const = 0;
  /// How long the window may wait when the player names no time for its next position of the face.
  [[nodiscard]] virtual Duration idle_time() const { return kIdle; }
  /// The window's title with what plays: "lecture.txt - AUcast". `over`: whether playing and its
  /// sound have ended.
  [[nodiscard]] virtual std::string title(const std::string& program, bool over) const = 0;
  [[nodiscard]] virtual Played played() const = 0;
  /// Whether the stream comes from a server that the user chose.
  [[nodiscard]] virtual bool of_chosen_server() const { return false; }
  /// Whether the user chose the server, and the server has ended the stream.
  [[nodiscard]] virtual bool ended_by_server() const { return false; }
  /// Adds to `view` what only this kind of stream has.
  virtual void describe(gui::PlayingView& view) const = 0;
  [[nodiscard]] virtual gui::LocalView local_view() const { return {}; }
};

}  // namespace aucast::app
