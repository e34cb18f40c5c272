#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gui/model/au_curves.h"
#include "common/time.h"

namespace aucast::gui {

/// Whether something plays, which decides what the user can do now.
enum class Activity : std::uint8_t {
  Idle,        ///< nothing has been opened yet
  Connecting,  ///< the server has not answered yet
  Playing,     ///< also buffering and stalled
  Paused,
  Over,  ///< ended, stopped or lost: the last face stays
};

/// One buffer as a bar.
struct BufferBar {
  std::size_t fill = 0;
  std::size_t capacity = 1;
  int threshold_percent = 0;  ///< the position of the mark; 0: no mark
  friend bool operator==(const BufferBar&, const BufferBar&) = default;
};

/// One AU, in the keyframe under way and on the face at this moment.
struct AuRow {
  std::string label;          ///< "12", "L14"
  std::string name;           ///< of FACS, or the user's own; empty: it has none
  int received_percent = 0;   ///< 0: not received; a rule added it, or it is fading
  int shown_percent = 0;      ///< 0: a rule removed it, or it does not show yet
  std::string why;            ///< the rule that changed it; empty: none did
  bool room_for_why = false;  ///< the row has room for a reason even if there is none
  friend bool operator==(const AuRow&, const AuRow&) = default;
};

/// The intensity of one AU over the last half minute.
struct AuTrace {
  int number = 0;
  std::vector<float> values;  ///< in [0,1], oldest first
  friend bool operator==(const AuTrace&, const AuTrace&) = default;
};
/// The most lines in one plot; more could not be told apart.
inline constexpr std::size_t kTracesMax = 6;

/// What plays: the stream of a server, or a stream file.
struct PlayingView {
  Activity activity = Activity::Idle;
  std::string state;         ///< in words: "buffering 42 %"
  std::string detail;        ///< why it ended, as a sentence; empty unless something went wrong
  bool tries_again = false;  ///< the server was lost and will be tried again
  int again_s = 0;           ///< seconds until the next attempt; 0: now
  std::string stream;        ///< the name of the stream, as the server says; empty: the server
                             ///< names none, or nothing plays
  std::string ended_by;  ///< "host:port" of the server that has ended the stream; empty: none has
  bool stale = false;    ///< the face shown is the last of a lost connection
  bool eased = false;    ///< nothing came for a long time, and the face has gone to neutral
  bool timed = false;    ///< keyframes have times of their own, so the speed has no effect
  bool local = false;    ///< the stream is available whole: buffers and bytes have no meaning
  std::optional<bool> live{};  ///< whether a server's stream is live; nullopt: not known yet
  BufferBar receiver;
  BufferBar playout;
  std::vector<float> receiver_history;  ///< fill in [0,1] over the last half minute, oldest first
  std::vector<AuTrace> au_history;      ///< the strongest AUs over the same time
  std::string in;                       ///< "6 packets, 93 B, 0.4 kbit/s"; empty: none yet
  std::string out;                      ///< "12 B, 0.1 kbit/s"
  std::string protocol;                 ///< "level 2", "classic"
  std::string delay;                    ///< "42 ms (at most 57, wanted 41)"; empty: not live
  std::string keyframe;                 ///< "keyframe 3"; empty before the first
  std::vector<AuRow> aus;               ///< of the face that is shown, whichever session made it
  friend bool operator==(const PlayingView&, const PlayingView&) = default;
};

/// A stream that is available whole (a file, or a composed stream), and how far it has been played.
struct LocalView {
  bool open = false;
  std::string name;
  bool playing = false;
  Duration position{0};
  Duration total{0};
  std::shared_ptr<const std::vector<Duration>> ends;  ///< when each keyframe is reached; not null
                                                      ///< if `open`
  std::size_t keyframe = 0;                           ///< the keyframe under way, counted from 1
  int speed_percent = 100;
  std::optional<Duration> loop_begin;
  std::optional<Duration> loop_end;
  bool repeats = false;                      ///< the whole stream is repeated
  int step_fps = 25;                         ///< a step by frame is 1 / step_fps s
  std::shared_ptr<const AuCurves> curves{};  ///< one per AU; null: not known
  friend bool operator==(const LocalView&, const LocalView&) = default;
};

// The commands for such a stream, besides Pause and Resume.

struct Seek {
  Duration position{0};
};
struct SeekBy {
  Duration time{0};  ///< below 0: back
};
struct StepKeyframe {
  int direction = 1;  ///< -1: back
};
struct StepFrame {
  int direction = 1;
};
struct SetSpeed {
  int percent = 100;
};
struct ChangeSpeed {
  int direction = 1;  ///< 1: to the next of LocalPlayback::kSpeeds; -1: to the one before
};
struct MarkLoop {};
/// Turns the repetition of the whole stream on or off.
struct ToggleRepeat {};

using LocalCommand = std::variant<Seek, SeekBy, StepKeyframe, StepFrame, SetSpeed, ChangeSpeed,
                                  MarkLoop, ToggleRepeat>;

}  // namespace aucast::gui
