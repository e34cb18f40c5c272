#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <asio/io_context.hpp>

#include "common/link/loop_timer.h"
#include "common/result.h"
#include "common/time.h"
#include "protocol/packet.h"
#include "protocol/server_session.h"
#include "server/engine/bus.h"
#include "server/engine/outgoing_batches.h"
#include "server/status/status.h"

namespace aucast::server {

/// Sends this server's first stream over an engine, and answers everybody who joins there.
/// Thread: that of the io_context, which must outlive it.
class EngineOrigin {
 public:
  struct Options {
    std::string stream;     ///< its name at the engine
    Milliseconds batch{0};  ///< what comes within this time is sent as one batch
  };
  using Catalogue = std::function<std::shared_ptr<const protocol::ServerCatalogue>()>;

  /// How often it sends an empty batch, to show that it is alive, when there is nothing new.
  static constexpr Milliseconds kBeat{500};
  /// Requests beyond this number in one second are left out and counted.
  static constexpr std::size_t kAnswersPerSecond = 1'000;

  EngineOrigin(asio::io_context& io, Options options, Catalogue catalogue);
  EngineOrigin(const EngineOrigin&) = delete;
  EngineOrigin& operator=(const EngineOrigin&) = delete;

  /// Opens the bus. Errors are those of `open`.
  [[nodiscard]] Result<void> start(const OpenBus& open);
  /// Call when a stream may have something new.
  void on_moment();
  /// Tells the edges that the stream has ended.
  void stop();
  /// Adds its state to `status`.
  void describe(Status& status) const;

 private:
  [[nodiscard]] std::shared_ptr<const protocol::LiveChannel> channel();
  void say_why_not(const std::string& why);
  void begin(const std::shared_ptr<const protocol::LiveChannel>& channel);
  void end();
  void on_message(const Bus::Message& message);
  void flush_soon();
  void flush();
  void await_beat();
  [[nodiscard]] bool may_answer();

  Options options_;
  Catalogue catalogue_;
  std::unique_ptr<Bus> bus_;
  bool connected_ = false;
  std::shared_ptr<const protocol::LiveChannel> channel_;  ///< the one that is sent; null: none
  protocol::HelloGranted hello_;
  std::optional<OutgoingBatches> batches_;
  std::string said_why_not_;     ///< why nothing is published, as the log said last
  link::LoopTimer batch_timer_;  ///< for the end of the batch
  bool batch_begun_ = false;     ///< something waits for that
  link::LoopTimer beat_timer_;   ///< for the next empty batch
  Instant second_begin_{};
  std::size_t answers_ = 0;  ///< sent in that second
  std::uint64_t unanswered_ = 0;
  bool stopped_ = false;
};

}  // namespace aucast::server
