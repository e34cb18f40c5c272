#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/action_unit.h"
#include "common/result.h"
#include "common/time.h"
#include "protocol/client_session.h"
#include "protocol/encoded_stream.h"
#include "protocol/encoded_track.h"
#include "protocol/live_feed.h"
#include "protocol/upstream_stream.h"

namespace aucast::server {

/// A stream as it comes from its parents, one after the other, and as it is served here: a recorded
/// one is kept and grows, of a live one there is only the newest moment. Packets are passed on as
/// they came; only forms that the parent did not send are made here. Voice and captions go with
/// them. No socket and no clock. Thread: none of its own.
class RelayedStream {
 public:
  struct Options {
    std::string name;  ///< what is asked for; empty: the parent's first
    int classic_min = 20;
    Milliseconds patience{0};  ///< how long a client waits for a stream that is not known yet
    /// Whether so many bytes of a recorded stream may be held.
    std::function<Result<void>(std::uint64_t bytes)> may_hold;
  };

  explicit RelayedStream(Options options);

  /// What the next parent is asked for: of a recorded stream, what is still missing.
  [[nodiscard]] protocol::HelloAsked asked() const;

  /// All that comes until the next call came together: clients get as much of it as they can take.
  void begin_call();

  // What a parent says. Each returns what is wrong with it, if anything: then nothing was changed,
  // and this parent is of no use.

  [[nodiscard]] std::optional<std::string> begin(const protocol::HelloGranted& hello);
  /// `packet`: the bytes of the keyframe as they came.
  [[nodiscard]] std::optional<std::string> add(const protocol::DeliverKeyframe& keyframe,
                                               std::string_view packet);
  [[nodiscard]] std::optional<std::string> add(const protocol::DeliverVoice& voice);
  [[nodiscard]] std::optional<std::string> add(const protocol::DeliverCaption& caption);
  /// {-2}. A live stream may go on with the next parent.
  [[nodiscard]] std::optional<std::string> end();

  /// Nobody sends it any more: its clients are told so. It goes on when somebody sends it again.
  void give_up();

  /// What sessions hold.
  [[nodiscard]] std::shared_ptr<const protocol::UpstreamStream> shared() const { return shared_; }
  [[nodiscard]] bool live() const { return feed_ != nullptr; }
  /// A recorded stream is here to its end: nothing is asked for any more.
  [[nodiscard]] bool whole() const;
  /// How far a recorded stream has come.
  [[nodiscard]] Milliseconds place() const { return Milliseconds(place_ms_); }

 private:
  [[nodiscard]] bool begun() const { return feed_ || recorded_; }
  void forget_announced();
  void show_recorded();
  [[nodiscard]] std::optional<std::string> objection(const protocol::HelloGranted& hello) const;
  [[nodiscard]] std::optional<std::string> keep(const protocol::EncodedKeyframe& keyframe,
                                                std::uint32_t time_ms);
  [[nodiscard]] std::optional<std::string> no_room();

  Options options_;
  std::shared_ptr<protocol::UpstreamStream> shared_;
  std::shared_ptr<protocol::LiveFeed> feed_;           ///< of a live stream
  std::shared_ptr<protocol::EncodedStream> recorded_;  ///< of a recorded one
  bool changes_ = false;  ///< of a recorded one the changes-only form is kept too
  std::uint64_t place_ms_ = 0;
  std::size_t sent_again_ = 0;  ///< keyframes of 0 ms that the parent may begin with, and are here
  std::shared_ptr<protocol::SpokenTrack> spoken_;  ///< of a recorded stream; null: it has none
  std::shared_ptr<protocol::EncodedTrack> voice_;  ///< of that; null: it has captions only
  std::size_t caption_bytes_ = 0;                  ///< of that
  std::uint64_t looks_ = 0;  ///< at whether there is room for more of a recorded stream
  Milliseconds shift_{0};    ///< live: from the clock of the connection to that of the feed
};

}  // namespace aucast::server
