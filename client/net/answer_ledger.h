#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/client_session.h"
#include "protocol/limits.h"

namespace aucast::net {

/// Counts the keyframes that are not answered yet, and decides when to send answers and pauses.
/// Thread: none of its own.
class AnswerLedger {
 public:
  /// What the codes to send depend on, besides the answers owed.
  struct Wishes {
    bool user_paused = false;
    bool full = false;   ///< there is no room for more keyframes
    bool voice = false;  ///< the stream has a voice; answers are then sent several at a time, as
                         ///< the link may be slow
  };

  /// Call it when a keyframe has come: one more answer is owed.
  void owe(Instant now);
  /// Call it when the connection is gone: no answers are owed any more.
  void forget() { owed_ = 0; }
  [[nodiscard]] bool has_room() const { return owed_ < protocol::kOwedAnswersMax; }

  /// The codes to send now.
  [[nodiscard]] std::string speak(protocol::ClientSession& session, const Wishes& wishes,
                                  Instant now);
  /// Whether speak() would return anything.
  [[nodiscard]] bool has_output(const protocol::ClientSession& session, const Wishes& wishes,
                                Instant now) const;
  /// When answers that wait to be sent together must be sent; nullopt: none wait.
  [[nodiscard]] std::optional<Instant> deadline(const protocol::ClientSession& session,
                                                const Wishes& wishes, Instant now) const;

  [[nodiscard]] std::uint64_t pauses_sent() const { return pauses_sent_; }
  [[nodiscard]] std::uint64_t resumes_sent() const { return resumes_sent_; }

 private:
  [[nodiscard]] bool gathers(const protocol::ClientSession& session, const Wishes& wishes,
                             Instant now) const;
  [[nodiscard]] std::string speak_classic(protocol::ClientSession& session, const Wishes& wishes);
  [[nodiscard]] std::string speak_negotiated(protocol::ClientSession& session,
                                             const Wishes& wishes);
  [[nodiscard]] std::string pause(protocol::ClientSession& session);
  [[nodiscard]] std::string resume(protocol::ClientSession& session);

  std::size_t owed_ = 0;  ///< keyframes received and not answered
  Instant owed_since_{};
  std::uint64_t pauses_sent_ = 0;
  std::uint64_t resumes_sent_ = 0;
};

}  // namespace aucast::net
