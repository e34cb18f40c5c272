#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/action_unit.h"
#include "common/time.h"
#include "protocol/client_session.h"
#include "protocol/live_feed.h"
#include "protocol/upstream_stream.h"
#include "server/upstream/relayed_recording.h"

namespace aucast::server {

/// A stream that comes from parents, one after the other, and is served here. A recorded one is
/// kept and grows (RelayedRecording); of a live one there is only the newest moment. Packets are
/// passed on as they came; only forms that the parent did not send are made here. Voice and
/// captions are passed on too. No socket and no clock. Thread: none of its own.
class RelayedStream {
 public:
  /// Takes the name for a stream that is to be served; false: another one has it.
  using TakeName = std::function<bool(const std::string& name)>;
  struct Options {
    std::string name;  ///< the name to ask for; empty: the parent's first
    int classic_min = 20;
    Milliseconds patience{0};  ///< how long a client waits for a stream that is not known yet
    RelayedRecording::MayHold may_hold;
    TakeName take_name{};  ///< called with the name of the parent's first; none: every name is free
  };

  explicit RelayedStream(Options options);

  /// The hello for the next parent; for a recorded stream it asks only for what is missing.
  [[nodiscard]] protocol::HelloAsked asked() const;

  /// Call it before adding what has come together: clients then get as much of that as they can
  /// take.
  void begin_call();

  // What comes from a parent. Each returns what is wrong with it, or nullopt. If anything is wrong,
  // nothing was changed, and the parent must be left.

  [[nodiscard]] std::optional<std::string> begin(const protocol::HelloGranted& hello);
  /// `packet`: the keyframe's bytes as they came.
  [[nodiscard]] std::optional<std::string> add(const protocol::DeliverKeyframe& keyframe,
                                               std::string_view packet);
  [[nodiscard]] std::optional<std::string> add(const protocol::DeliverVoice& voice);
  [[nodiscard]] std::optional<std::string> add(const protocol::DeliverCaption& caption);
  /// {-2} has come. A live stream may go on with the next parent.
  [[nodiscard]] std::optional<std::string> end();

  /// Ends the stream for its clients, since nobody sends it. It goes on when somebody sends it
  /// again.
  void give_up();

  /// The stream as the sessions use it.
  [[nodiscard]] std::shared_ptr<const protocol::UpstreamStream> shared() const { return shared_; }
  [[nodiscard]] bool live() const { return feed_ != nullptr; }
  /// Of a live stream: those that came too far ahead of the face.
  [[nodiscard]] std::uint64_t captions_left_out() const {
    return feed_ ? feed_->captions_left_out() : 0;
  }
  /// Whether it is a recorded stream that is here to its end, so that nothing is missing.
  [[nodiscard]] bool whole() const { return recording_ && recording_->whole(); }
  /// How much of a recorded stream is here.
  [[nodiscard]] Milliseconds place() const { return Milliseconds(place_ms()); }

 private:
  /// Of a recorded stream without keyframes no client was sent any, so the next parent may have
  /// another one.
  [[nodiscard]] bool begun() const { return shared_->known(); }
  [[nodiscard]] std::uint64_t place_ms() const { return recording_ ? recording_->place_ms() : 0; }
  void show_recording();
  [[nodiscard]] std::optional<std::string> objection(const protocol::HelloGranted& hello) const;

  Options options_;
  std::shared_ptr<protocol::UpstreamStream> shared_;
  // One of them, as soon as it is known what the stream is.
  std::optional<RelayedRecording> recording_;
  std::shared_ptr<protocol::LiveFeed> feed_;  ///< of a live stream
  Milliseconds shift_{0};  ///< live: from the clock of the connection to that of the feed
};

}  // namespace aucast::server
