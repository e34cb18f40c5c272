#include "client/net/answer_ledger.h"

#include <algorithm>

namespace aucast::net {
namespace {

/// Answers are collected and sent together: the first one waits at most this long, ...
constexpr Milliseconds kAnswersLate{250};
/// ... and none once a quarter of the window is owed.
constexpr std::size_t kWindowPartOwed = 4;

bool negotiated(const protocol::ClientSession& session) {
  return session.level() == protocol::Level::Negotiated;
}

}  // namespace

void AnswerLedger::owe(Instant now) {
  if (owed_++ == 0) owed_since_ = now;
}

std::string AnswerLedger::speak(protocol::ClientSession& session, const Wishes& wishes,
                                Instant now) {
  if (!negotiated(session)) return speak_classic(session, wishes);
  return gathers(session, wishes, now) ? std::string() : speak_negotiated(session, wishes);
}

std::string AnswerLedger::speak_classic(protocol::ClientSession& session, const Wishes& wishes) {
  std::string words;
  if (session.paused()) {
    if (wishes.user_paused || wishes.full) return words;
    words += resume(session);
  }
  while (owed_ > 0) {
    const bool pauses = wishes.user_paused || (wishes.full && owed_ == 1);
    --owed_;
    if (pauses) return words + pause(session);  // -1 is an answer too
    words += session.answer_received();
  }
  return words;
}

std::string AnswerLedger::speak_negotiated(protocol::ClientSession& session, const Wishes& wishes) {
  std::string words;
  const bool must_pause = wishes.user_paused || wishes.full;
  // First the pause, then the answers: the other way round each answer would let one more packet
  // go than there is room for.
  if (must_pause && !session.paused()) words += pause(session);
  for (; owed_ > 0; --owed_) words += session.answer_received();
  if (!must_pause && session.paused()) words += resume(session);
  return words;
}

/// Whether answers wait to be sent together. Each packet of answers costs a TCP acknowledgement:
/// with a voice, which is meant for slow links, several answers share one.
bool AnswerLedger::gathers(const protocol::ClientSession& session, const Wishes& wishes,
                           Instant now) const {
  const auto window = static_cast<std::size_t>(std::max(session.window(), 0));
  return wishes.voice && negotiated(session) && !wishes.user_paused && !session.paused() &&
         !wishes.full && owed_ > 0 && owed_ < window / kWindowPartOwed &&
         now < owed_since_ + kAnswersLate;
}

bool AnswerLedger::has_output(const protocol::ClientSession& session, const Wishes& wishes,
                              Instant now) const {
  if (gathers(session, wishes, now)) return false;
  if (negotiated(session)) {
    return owed_ > 0 || session.paused() != (wishes.user_paused || wishes.full);
  }
  if (wishes.user_paused) return !session.paused() && owed_ > 0;
  if (wishes.full || !session.paused()) return owed_ > (wishes.full ? 1 : 0);
  return true;
}

std::optional<Instant> AnswerLedger::deadline(const protocol::ClientSession& session,
                                              const Wishes& wishes, Instant now) const {
  if (!gathers(session, wishes, now)) return std::nullopt;
  return owed_since_ + kAnswersLate;
}

std::string AnswerLedger::pause(protocol::ClientSession& session) {
  std::string words = session.pause();
  if (!words.empty()) ++pauses_sent_;
  return words;
}

std::string AnswerLedger::resume(protocol::ClientSession& session) {
  std::string words = session.resume();
  if (!words.empty()) ++resumes_sent_;
  return words;
}

}  // namespace aucast::net
