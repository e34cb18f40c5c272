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

/// A live stream on its way to an engine: batches of what its channel has, numbered, and answers to
/// who joins late or has missed some. Places are those of the channel's clock.
/// Thread: none of its own; that of the channel.
class Publication {
 public:
  /// What was published is kept so long for who has missed it.
  static constexpr Milliseconds kKept{2'000};
  /// One answer holds it with its line.
  static constexpr std::size_t kKeptBytesMax = std::size_t{48} * 1024;
  static constexpr std::size_t kKeptMax = 256;  ///< batches, of which many may be empty

  explicit Publication(std::string origin) : origin_(std::move(origin)) {}

  /// Adds to the next batch what the channel has that was not taken yet. What is heard comes before
  /// the keyframe that it is heard in.
  void collect(const protocol::LiveChannel& channel);
  /// Adds {-2}: nothing follows for now.
  void collect_end();
  /// Of the packets of the next batch.
  [[nodiscard]] std::size_t waiting_bytes() const { return waiting_.size(); }
  /// What was collected, with the next number. Without anything it says that the origin lives.
  [[nodiscard]] std::string next_batch();

  /// The stream goes on: who asks can be told the state of the face.
  [[nodiscard]] bool running() const { return !full_.empty() && !ended_; }
  /// What is said to who joins, as of the last batch. `hello`: of the stream. Nothing: it asks
  /// another origin, or nothing was published.
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
    std::string caption;  ///< that stands; empty: none
  };

  void collect_sound(const protocol::LiveChannel& channel);
  void keep(Kept batch);
  [[nodiscard]] std::optional<std::string> since(std::uint64_t after) const;

  std::string origin_;
  std::uint64_t seq_ = 0;  ///< of the last batch; the first one has 1
  std::string waiting_;
  std::optional<std::uint64_t> last_moment_;
  Milliseconds end_{0};            ///< of the last keyframe that was collected
  Milliseconds waiting_place_{0};  ///< where the next batch begins
  std::uint64_t next_voice_ = 0;   ///< numbers in the channel
  std::uint64_t next_caption_ = 0;
  bool ended_ = false;
  std::string full_;  ///< of the last moment collected, ...
  Milliseconds full_begin_{0};
  std::string caption_;
  State published_;  ///< ... and of the last one in a batch that is out
  std::deque<Kept> kept_;
  std::size_t kept_bytes_ = 0;
};

}  // namespace aucast::server
