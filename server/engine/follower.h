#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/time.h"
#include "protocol/engine_message.h"
#include "server/engine/ask_times.h"
#include "server/engine/recurring_complaint.h"

namespace aucast::server {

/// Puts the messages of an engine in order, as ENGINE.md says. It joins one origin (a publisher's
/// run), finds gaps by the batches' numbers and asks for what is missing, takes nothing twice, and
/// leaves an origin that is silent. No connection and no clock: messages and the time go in, events
/// come out.
/// Thread: none of its own.
class Follower {
 public:
  static constexpr Milliseconds kSilence{2'000};  ///< after this silence, an origin counts as lost
  static constexpr Milliseconds kSayEvery{60'000};  ///< how often a warning is repeated at most
  /// The most batches that wait for an answer. When more come, the oldest are dropped and counted.
  static constexpr std::size_t kWaitingMax = 128;
  static constexpr std::size_t kWaitingBytesMax = std::size_t{1} << 20U;

  struct Ask {
    std::string request;
  };
  /// The stream begins, or begins anew, with the hello and the whole face; places are on a clock
  /// that begins now.
  struct Begin {
    std::string origin;
    std::string packets;
  };
  struct GoOn {
    std::string packets;  ///< their places are on the same clock
  };
  /// The stream that began is lost.
  struct Lose {
    std::string reason;  ///< a clause
  };
  struct Say {
    std::string text;  ///< a warning for the log
  };
  using Event = std::variant<Ask, Begin, GoOn, Lose, Say>;

  /// `id`: of this server, by which it notices if its own stream comes back.
  explicit Follower(std::string id) : id_(std::move(id)) {}

  /// Call when the engine is connected, for the first time or again: something may have been
  /// missed.
  [[nodiscard]] std::vector<Event> on_connected(Instant now);
  void on_disconnected() { connected_ = false; }
  /// Takes a message that was sent to everybody; anybody may have sent it.
  [[nodiscard]] std::vector<Event> on_broadcast(std::string_view bytes, Instant now);
  /// Takes an answer to a question of ours.
  [[nodiscard]] std::vector<Event> on_answer(std::string_view bytes, Instant now);
  /// Call when the receiver has left the stream, because it has ended or is invalid.
  [[nodiscard]] std::vector<Event> on_over(Instant now);
  [[nodiscard]] std::vector<Event> on_time(Instant now);
  [[nodiscard]] std::optional<Instant> deadline() const;

  /// How many batches were dropped while they waited for an answer.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

 private:
  using Message = protocol::EngineMessage;

  [[nodiscard]] std::vector<Event> take_events();
  void take_batch(Message message, Instant now);
  void take_state(const Message& message, Instant now);
  void take_since(const Message& message, Instant now);
  [[nodiscard]] std::optional<std::string> objection(const Message& state) const;
  void pass(const Message& message);
  void drain();
  void keep(Message message);
  void forget();
  void want(Instant now);
  void answered(Instant now);
  void complain(RecurringComplaint& complaint, const std::string& text, Instant now);
  void complain_of_other(const std::string& origin, Instant now);

  std::string id_;
  std::optional<std::string> origin_;
  std::uint64_t last_ = 0;     ///< the last batch that was passed on
  std::uint64_t base_ms_ = 0;  ///< place on the origin's clock where ours is 0
  Instant heard_at_{};         ///< when the origin was last heard
  bool connected_ = false;
  bool asking_ = false;  ///< whether an answer is awaited
  AskTimes ask_times_{kSilence};
  std::deque<Message> waiting_;  ///< batches that came while an answer was awaited
  std::size_t waiting_bytes_ = 0;
  std::uint64_t left_out_ = 0;
  RecurringComplaint garbage_{kSayEvery};
  RecurringComplaint other_origin_{kSayEvery};
  RecurringComplaint refused_{kSayEvery};
  std::vector<Event> events_;
};

}  // namespace aucast::server
