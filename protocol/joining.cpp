#include "protocol/joining.h"

#include <string>
#include <utility>

#include "protocol/limits.h"
#include "protocol/secret.h"

namespace aucast::protocol {

/// The sentences for a client without a token and for one with a wrong token.
struct Joining::TokenWords {
  const char* none;
  const char* wrong;

  static constexpr TokenWords viewers() {
    return {"a token is needed here (--token-file)",
            "this token does not open this server (--token-file)"};
  }
  static constexpr TokenWords publishers() {
    return {"a publisher's token is needed here (--accept-push)",
            "this token lets nobody publish here (--accept-push)"};
  }
};

Joining::Joining(const ServerCatalogue& catalogue, Admission admission, TokenCount token_count,
                 Silence silence)
    : catalogue_(&catalogue),
      owner_(admission == Admission::Owner),
      token_count_(token_count),
      silence_(silence) {
  if (admission == Admission::Full) no_room_ = "the server is full";
  if (admission == Admission::FullAddress) no_room_ = "too many clients from this address";
}

Joining::Answer Joining::hello(const HelloAsked& asked, Instant now) const {
  if (asked.version != kProtocolVersion) {
    return Refusal{{kOtherVersion, "version " + std::to_string(asked.version) +
                                       " is not spoken here, only " +
                                       std::to_string(kProtocolVersion)}};
  }
  if (!asked.publish.empty()) return publisher(asked, now);
  // Before anything else is told: what is served here is no stranger's business.
  if (auto refusal = viewer_refused(asked.token, now)) return std::move(*refusal);
  return stream_of(asked);
}

Joining::Answer Joining::list(const StreamsAsked& asked, Instant now) const {
  if (auto refusal = viewer_refused(asked.token, now)) return std::move(*refusal);
  StreamList list;
  for (const ServedStream& served : catalogue_->streams) {
    list.streams.push_back(asked.details ? served.listed(catalogue_->loop)
                                         : ListedStream{served.known_name()});
  }
  return list;
}

Joining::Answer Joining::classic(Instant now) const {
  if (auto refusal = viewer_refused({}, now)) return std::move(*refusal);
  if (silence_ == Silence::Refused) {
    return Refusal{{kMalformed, "a hello is needed here, as the very first bytes"}};
  }
  if (no_room_ != nullptr) return Refusal{{kBusy, no_room_}, true};
  return stream_of(std::nullopt);
}

Joining::Answer Joining::stream_of(const std::optional<HelloAsked>& asked) const {
  StreamChoice choice = choose_stream(*catalogue_, asked);
  if (choice.state == StreamChoice::State::Refused) return Refusal{std::move(choice.refusal)};
  if (no_room_ != nullptr) return Refusal{{kBusy, no_room_}};
  return choice;
}

/// A page has no stream to offer: such a hello over a WebSocket comes from another site's page.
Joining::Answer Joining::publisher(const HelloAsked& asked, Instant now) const {
  using Verdict = Publishers::Verdict;
  if (!catalogue_->publishers || silence_ == Silence::Refused) {
    return Refusal{{kNotAllowed, "streams are not taken here (--accept-push)"}};
  }
  constexpr TokenWords kWords = TokenWords::publishers();
  if (auto refusal = may_not_show(asked.token, kWords, now)) return std::move(*refusal);
  const Verdict verdict = catalogue_->publishers->verdict(asked.token, asked.publish);
  if (verdict == Verdict::Unknown) return wrong_token(kWords, now);
  if (verdict == Verdict::OtherNames) {
    return Refusal{{kNotAllowed, "this token is not for the stream '" + asked.publish + "'"}};
  }
  if (auto refusal = catalogue_->publish_refused(asked)) return Refusal{std::move(*refusal)};
  return HandOver{asked};
}

/// nullopt: the token is right, or none is needed.
std::optional<Joining::Refusal> Joining::viewer_refused(std::string_view token, Instant now) const {
  if (owner_) {
    // It cannot be guessed. If tries were counted, others of this host would shut the owner out.
    const std::string& wanted = catalogue_->owner_token;
    if (!wanted.empty() && same_secret(token, wanted)) return std::nullopt;
    return Refusal{
        {kTokenNeeded, "only the program that started this server may watch here (--preview)"}};
  }
  constexpr TokenWords kWords = TokenWords::viewers();
  if (catalogue_->token.empty()) return std::nullopt;
  if (auto refusal = may_not_show(token, kWords, now)) return refusal;
  if (same_secret(token, catalogue_->token)) return std::nullopt;
  return wrong_token(kWords, now);
}

/// nullopt: the token may be compared.
std::optional<Joining::Refusal> Joining::may_not_show(std::string_view token,
                                                      const TokenWords& words, Instant now) const {
  if (token.empty()) return Refusal{{kTokenNeeded, words.none}};
  // Whether this one is right must not show.
  if (!token_count_.may_try(now))
    return Refusal{{kBusy, "too many wrong tokens from this address"}};
  return std::nullopt;
}

Joining::Refusal Joining::wrong_token(const TokenWords& words, Instant now) const {
  token_count_.add_wrong(now);
  return {{kTokenNeeded, words.wrong}, false, kWrongTokenWait};
}

}  // namespace aucast::protocol
