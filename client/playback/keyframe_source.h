#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::playback {

/// One set of AUs with the time to reach it, on its way from the wire to the face (its wire form is
/// protocol::Keyframe). Here the places of keyframes, voice and captions are all on one clock: the
/// client's (PROTOCOL.md, Voice) or the file's. Places on the wire are on another clock.
struct Keyframe {
  AuFrame aus;
  std::optional<Milliseconds> time;     ///< the packet's own time, if it had one
  int pace_percent = 100;               ///< live: percentage of its time that it takes, 95-105
  std::optional<Instant> arrived{};     ///< live: when it came
  std::optional<Instant> due{};         ///< --live: when the face should have reached it
  std::optional<Milliseconds> place{};  ///< where it is reached
  Milliseconds span{0};                 ///< its length on the clock of places, whatever --speed
                                        ///< says
  bool spoken = false;                  ///< live: a voice is heard meanwhile, so the pace stays
                                        ///< within 99.5-100.5 %, whatever pace_percent says
};

/// The most bytes of voice that wait to be taken: an hour at 24 kbit/s.
inline constexpr std::size_t kVoiceBytesMax = std::size_t{11} << 20U;
/// The most packets of voice that wait: an hour of the shortest, 10 ms each. They have a limit of
/// their own because even a packet of few bytes takes memory.
inline constexpr std::size_t kVoicePacketsMax = 360'000;

/// One Opus packet of a source's voice.
struct Voice {
  Milliseconds place{0};  ///< where its sound begins
  std::string opus;
};

/// The caption from a place on, until the next one; empty: none.
struct Caption {
  Milliseconds place{0};
  std::string text;  ///< UTF-8
};

/// Why a source has nothing more to give.
enum class EndReason : std::uint8_t {
  NotEnded,
  EndOfStream,  ///< {-2} came, or the file has no more keyframes
  Stopped,      ///< stop() was called
  ConnectionLost,
  ProtocolError,
  Unreachable,  ///< never connected, or silent past the time-out
  Refused,      ///< the server's {error ...}
};

/// "end_of_stream", "stopped", ... as --stats writes it.
[[nodiscard]] std::string_view name(EndReason reason);

/// A snapshot of a source, for the controller, the statistics and the window.
struct SourceStatus {
  bool connected = false;
  EndReason end = EndReason::NotEnded;  ///< set as soon as nothing more will arrive
  std::string detail;                   ///< a sentence about the end, for the user
  std::string reason;                   ///< why a connection will be tried again: the cause alone
  Milliseconds retry_after{0};          ///< from the loss to the next attempt
  std::optional<int> refusal;           ///< Refused: the server's code
  std::size_t receiver_fill = 0;
  std::size_t playout_fill = 0;
  Milliseconds keyframe_time{250};      ///< the server's default for untimed packets
  bool local = false;                   ///< no server's: it is there whole
  bool negotiated = false;              ///< level 2
  bool live = false;                    ///< the server has one clock for all
  bool voice = false;                   ///< a voice comes with the stream
  bool captions = false;                ///< captions come with it
  std::string stream;                   ///< its name as the server gives it; empty: it gives none
  std::string title;                    ///< of the stream; empty: none
  std::uint64_t keyframes_dropped = 0;  ///< live: to catch up
  std::uint64_t voice_left_out = 0;     ///< packets dropped because their queue was full
  std::uint64_t captions_left_out = 0;  ///< likewise
  Milliseconds delay{0};         ///< how much is to be buffered (live, --buffer auto or Nms);
                                 ///< --live: the time from arrival until the face is there
  Milliseconds buffered{0};      ///< how much is buffered now, in the stream's own time
  std::uint64_t reconnects = 0;  ///< attempts after a loss (--reconnect)
  bool paused = false;           ///< by the user, or by -1 because the buffers are full
  std::uint64_t keyframes_received = 0;
  std::uint64_t bytes_received = 0;
  std::uint64_t bytes_sent = 0;  ///< all that was sent, as bytes of the protocol
  std::uint64_t pauses_sent = 0;
  std::uint64_t resumes_sent = 0;
  double receive_seconds = 0;  ///< from connected to {-2} or the end
};

/// Where the playback controller gets keyframes from: a server or a file. A source may have a
/// thread behind it, but presents a single-threaded API: all calls come from the player's thread.
class KeyframeSource {
 public:
  KeyframeSource() = default;
  virtual ~KeyframeSource() = default;
  KeyframeSource(const KeyframeSource&) = delete;
  KeyframeSource& operator=(const KeyframeSource&) = delete;

  /// The next keyframe of the Playout buffer, if there is one now.
  [[nodiscard]] virtual std::optional<Keyframe> take() = 0;
  /// The next voice packet, if there is one. Places ascend. A packet is there before take() gives
  /// the keyframe during which it is heard.
  [[nodiscard]] virtual std::optional<Voice> take_voice() { return std::nullopt; }
  /// The same for captions.
  [[nodiscard]] virtual std::optional<Caption> take_caption() { return std::nullopt; }
  /// True when take() would give a keyframe, or nothing will ever come again.
  [[nodiscard]] virtual bool ready() const = 0;
  /// Waits until ready() or until `until`, whichever is first; returns ready().
  virtual bool wait_until(Instant until) = 0;
  [[nodiscard]] virtual SourceStatus status() const = 0;
  /// The user leaves: a server is sent -4. Returns at once; nothing more is given, and status().end
  /// becomes Stopped unless everything had been given already.
  virtual void stop() = 0;
  /// The user pauses or resumes: a server is asked to do the same. Keyframes already returned are
  /// not taken back.
  virtual void pause() {}
  virtual void resume() {}
};

}  // namespace aucast::playback
