#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/client_session.h"
#include "protocol/limits.h"

namespace aucast::net {

/// The keyframes that are not answered yet, and what is said to the server of them and of pauses.
/// Thread: none of its own.
class AnswerLedger {
 public:
  /// What its words depend on beside what is owed.
  struct Wishes {
    bool user_paused = false;
    bool full = false;   ///< there is no room for what would come
    bool voice = false;  ///< the stream has one: it goes over thin links
  };

  /// A keyframe has come.
  void owe(Instant now);
  /// The connection is gone, and with it what was owed.
  void forget() { owed_ = 0; }
  [[nodiscard]] bool has_room() const { return owed_ < protocol::kOwedAnswersMax; }

  /// All that is to be said now.
  [[nodiscard]] std::string speak(protocol::ClientSession& session, const Wishes& wishes,
                                  Instant now);
  /// speak() would say something.
  [[nodiscard]] bool has_words(const protocol::ClientSession& session, const Wishes& wishes,
                               Instant now) const;
  /// When answers that wait for each other are due; nothing: none wait.
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

  std::size_t owed_ = 0;  ///< keyframes not yet answered by `1` or -3
  Instant owed_since_{};
  std::uint64_t pauses_sent_ = 0;
  std::uint64_t resumes_sent_ = 0;
};

}  // namespace aucast::net
