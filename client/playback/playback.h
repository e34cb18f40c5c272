#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "client/playback/delay_meter.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/passing.h"
#include "common/time.h"

namespace aucast::playback {

enum class PlaybackState : std::uint8_t {
  Buffering,  ///< nothing has been played yet, the first keyframe is awaited
  Playing,
  Stalled,  ///< both buffers ran empty before the end: the clock waits, the face holds
  Stale,    ///< a stall lasted too long: the face eases to neutral and waits there
  Paused,   ///< by the user
  Ended,    ///< the stream has ended, and position 50 of its last keyframe is reached
  Stopped,  ///< the user left
  Lost,     ///< all that came is played, and the stream was cut short: connection lost, protocol
            ///< error, server unreachable or refusing; the face holds and eases as in Stale
};

[[nodiscard]] std::string_view name(PlaybackState state);

/// Whether `state` is Ended, Stopped or Lost: nothing moves any more, except that in Lost the face
/// eases to neutral.
[[nodiscard]] bool is_over(PlaybackState state);

/// A keyframe that has just begun: the face goes from where it is to `target`.
struct KeyframeBegun {
  Keyframe target;
  Milliseconds time{0};  ///< its own time: as it was sent, else --speed, else the server's
                         ///< default. A live keyframe may in fact take 5 % more or less
  /// How much of what came before was played, in [0,1]. Keyframes are played whole; only an easing
  /// to neutral may be interrupted.
  double cut_at = 1;
  std::optional<AuFrame> from{};  ///< the face begins from these AUs; nullopt: from where it is
};

/// How far playback has come.
struct PlaybackProgress {
  std::uint64_t keyframe = 0;  ///< counts from 1; 0 before the first
  int position = 0;  ///< the last position k of the current keyframe that was reached, 0..50
  double mu = 0;     ///< exact fraction in [0,1] of the current keyframe
};

class SeekablePlayback;

/// Decides which keyframe the face is on its way to, and how far it has come. Time is handed in and
/// must not go back; where there is sound, sound::SoundPlayer gives the time. Two kinds:
/// SourcePlayback plays what a source gives as it comes, SeekablePlayback plays a stream that is
/// available whole, at any place and speed.
/// Thread: none of its own.
class Playback {
 public:
  Playback() = default;
  virtual ~Playback() = default;
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  /// Moves to `now`. If a keyframe begins, it is returned: bring the face to the end of the one
  /// before, then begin this one. Call again with the same `now` until nullopt is returned, because
  /// short keyframes may have ended already.
  [[nodiscard]] virtual std::optional<KeyframeBegun> advance(Instant now) = 0;
  /// The face stays where it is at `now` until resume().
  virtual void pause(Instant now) = 0;
  virtual void resume(Instant now) = 0;
  /// The user leaves: no keyframe begins any more, and the face stays where it is at `now`.
  virtual void stop(Instant now) = 0;

  [[nodiscard]] virtual PlaybackState state() const = 0;
  /// True in Ended, Stopped and Lost.
  [[nodiscard]] bool over() const { return is_over(state()); }
  /// As of the last advance().
  [[nodiscard]] virtual PlaybackProgress progress() const = 0;
  /// Whether the face has left the last keyframe for neutral, because nothing has come for a long
  /// time.
  [[nodiscard]] virtual bool eased() const { return false; }
  /// When to call advance() next for a face that has moved visibly; nullopt if the face does not
  /// move.
  [[nodiscard]] virtual std::optional<Instant> next_position_at() const = 0;
  /// Where playing is, as of the last advance(). After the end the place goes on, for sound that
  /// lasts longer than the face. Nullopt if no places are known.
  [[nodiscard]] virtual std::optional<Passing> passing() const = 0;
  /// As KeyframeSource's functions of these names.
  [[nodiscard]] virtual std::optional<Voice> take_voice() { return std::nullopt; }
  [[nodiscard]] virtual std::optional<Caption> take_caption() { return std::nullopt; }
  /// Says that the times handed in from now on are `ahead` of the steady clock, and that a face is
  /// shown `lead` after its time was handed in. Both are zero before the first call.
  virtual void set_clock(Duration /*ahead*/, Duration /*lead*/) {}
  /// How many keyframes were played to their end, as of the last advance().
  [[nodiscard]] virtual std::uint64_t keyframes_played() const = 0;
  /// The sum of their times.
  [[nodiscard]] virtual Duration media_time() const = 0;
  [[nodiscard]] virtual std::uint64_t stalls() const { return 0; }
  /// How long live keyframes took from their arrival until they were reached.
  [[nodiscard]] virtual const DelayMeter& delays() const;
  /// How long live keyframes with a due time were meant to take until they were reached.
  [[nodiscard]] virtual const DelayMeter& delays_meant() const;
  /// Blocks until advance() may find a keyframe, or until `until`. Returns true in the first case.
  virtual bool wait_until(Instant /*until*/) { return true; }
  /// The status of what gives the keyframes.
  [[nodiscard]] virtual SourceStatus status() const = 0;
  /// This object, if it can seek; else null.
  [[nodiscard]] virtual SeekablePlayback* seekable() { return nullptr; }
};

}  // namespace aucast::playback
