#pragma once

#include <memory>
#include <string>
#include <utility>

#include "client/app/live_text.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/played.h"
#include "client/gui/gui_model.h"
#include "client/gui/stream_view.h"
#include "client/playback/playback.h"
#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::app {

/// The window waits no longer than this while something moves.
inline constexpr Milliseconds kFrameMax{20};

/// What plays in the window, and what the panels show of it. Two kinds: RemoteStream is a server's,
/// LocalStream is there whole. The times handed in are those of the player's clock.
/// Thread: the player's.
class PlayingStream {
 public:
  /// How long the window may wait before it should look again at a stream that does not move.
  static constexpr Milliseconds kIdle{250};

  PlayingStream() = default;
  virtual ~PlayingStream() = default;
  PlayingStream(const PlayingStream&) = delete;
  PlayingStream& operator=(const PlayingStream&) = delete;

  [[nodiscard]] virtual playback::Playback& playback() = 0;
  [[nodiscard]] virtual const playback::Playback& playback() const = 0;
  [[nodiscard]] bool running() const { return !playback().over(); }
  /// Hands out what plays; this object is only good to be destroyed then.
  [[nodiscard]] virtual std::unique_ptr<playback::Playback> hand_out() = 0;

  /// This keyframe has begun.
  virtual void begun(const playback::KeyframeBegun& /*keyframe*/) {}
  /// Playing has been moved to `now`, which is on the steady clock; `aus`: those of the face.
  virtual void advanced(Instant /*now*/, const AuFrame& /*aus*/) {}

  /// True once: a server has answered that is to be remembered.
  [[nodiscard]] virtual bool take_answer() { return false; }
  /// Why --live changes nothing for it.
  [[nodiscard]] virtual LiveObjection objection(const PlaybackOptions& /*options*/) const {
    return LiveObjection::None;
  }

  /// What Stop means while it runs.
  virtual void stop(Instant now) = 0;
  /// False: it cannot go on.
  virtual bool resume(Instant now) = 0;
  /// Only of what is there whole; true when its face is to be shown.
  virtual bool apply(const gui::LocalCommand& /*command*/, Instant /*now*/) { return false; }

  /// The face stands, and Resume would move it.
  [[nodiscard]] virtual bool stands() const = 0;
  /// How long the window may wait before it should look again, while no position is due.
  [[nodiscard]] virtual Duration idle_time() const { return kIdle; }
  /// The program's title with what plays: "lecture.txt - AUcast". `over`: what is heard of it has
  /// ended too.
  [[nodiscard]] virtual std::string title(const std::string& program, bool over) const = 0;
  [[nodiscard]] virtual Played played() const = 0;
  /// The server that the user chose has ended it.
  [[nodiscard]] virtual bool ended_by_server() const { return false; }
  /// Adds what is peculiar to this kind.
  virtual void describe(gui::PlayingView& view) const = 0;
  [[nodiscard]] virtual gui::LocalView local_view() const { return {}; }
};

}  // namespace aucast::app
