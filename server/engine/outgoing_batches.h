#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/engine_message.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"

namespace aucast::server {

/// Turns a live stream into messages for an engine: numbered batches of what is new in its channel,
/// and answers to those who join late or missed a batch. Places are on the channel's clock.
/// Thread: none of its own; that of the channel.
class OutgoingBatches {
 public:
  /// How long a sent batch is kept for those who missed it.
  static constexpr Milliseconds kKept{2'000};
  /// The most bytes that are kept: they fit in one answer.
  static constexpr std::size_t kKeptBytesMax = std::size_t{48} * 1024;
  static constexpr std::size_t kKeptMax = 256;  ///< batches; many may be empty

  explicit OutgoingBatches(std::string origin) : origin_(std::move(origin)) {}

  /// Adds what is new in the channel to the next batch. Voice and captions come before the keyframe
  /// that they go with.
  void collect(const protocol::LiveChannel& channel);
  /// Adds {-2}: the stream has ended, at least for now.
  void collect_end();
  /// The size in bytes of the next batch's packets.
  [[nodiscard]] std::size_t waiting_bytes() const { return waiting_.size(); }
  /// Returns the message with what was collected, under the next number. An empty batch shows that
  /// the origin is alive.
  [[nodiscard]] std::string next_batch();

  /// Whether the stream has begun and not ended.
  [[nodiscard]] bool running() const { return !full_.empty() && !ended_; }
  /// The answer, as of the last batch, to somebody who joins or missed batches. `hello`: the
  /// stream's. Returns nullopt if another origin is asked, or if there is nothing to answer with.
  [[nodiscard]] std::optional<std::string> answer(const protocol::EngineJoin& join,
                                                  const protocol::HelloGranted& hello) const;

 private:
  struct Kept {
    std::uint64_t seq = 0;
    Milliseconds place{0};  ///< where its first keyframe begins
    std::string packets;
  };
  struct State {
    std::string full;  ///< the whole face
    Milliseconds begin{0};
    std::string caption;  ///< the one that is shown; empty: none
  };

  void collect_spoken(const protocol::LiveChannel& channel);
  void keep(Kept batch);
  [[nodiscard]] std::optional<std::string> since(std::uint64_t after) const;

  std::string origin_;
  std::uint64_t seq_ = 0;  ///< of the last batch; the first is 1
  std::string waiting_;
  std::optional<std::uint64_t> last_moment_;
  Milliseconds end_{0};            ///< of the last keyframe that was collected
  Milliseconds waiting_place_{0};  ///< where the next batch begins
  std::uint64_t next_voice_ = 0;   ///< number in the channel's Recent
  std::uint64_t next_caption_ = 0;
  bool ended_ = false;
  std::string full_;  ///< the state at the last moment collected, ...
  Milliseconds full_begin_{0};
  std::string caption_;
  State sent_;  ///< ... and at the last moment in a batch that was sent
  std::deque<Kept> kept_;
  std::size_t kept_bytes_ = 0;
};

}  // namespace aucast::server
