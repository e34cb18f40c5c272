#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "common/time.h"
#include "protocol/packet.h"
#include "protocol/server_session.h"
#include "protocol/stream_choice.h"
#include "protocol/wrong_tokens.h"

namespace aucast::protocol {

/// Whether a client is let in, and to what: the order in which its version, token, stream and the
/// room for it are looked at. Says nothing itself. Thread: none of its own; one for each client.
class Joining {
 public:
  struct Refusal {
    ErrorReply reply;
    /// The client is a classic one, and is closed without a word.
    bool silent = false;
    Duration after{};  ///< held back for so long, since whoever guesses tokens is to wait
  };
  /// A stream that is here or may come (never StreamChoice::State::Refused), the refusal, a
  /// publisher that is taken, or the list that was asked for.
  using Answer = std::variant<StreamChoice, Refusal, HandOver, StreamList>;

  /// The catalogue must outlive it.
  Joining(const ServerCatalogue& catalogue, Admission admission, TokenCount token_count,
          Silence silence);

  [[nodiscard]] Answer hello(const HelloAsked& asked, Instant now) const;
  [[nodiscard]] Answer list(const StreamsAsked& asked, Instant now) const;
  /// Of a client that says no hello.
  [[nodiscard]] Answer classic(Instant now) const;
  /// For who was let in and has waited: its stream, if it is here now. `asked`: nothing for a
  /// classic client.
  [[nodiscard]] Answer stream_of(const std::optional<HelloAsked>& asked) const;

 private:
  struct TokenWords;

  [[nodiscard]] Answer publisher(const HelloAsked& asked, Instant now) const;
  [[nodiscard]] std::optional<Refusal> viewer_refused(std::string_view token, Instant now) const;
  [[nodiscard]] std::optional<Refusal> may_not_show(std::string_view token, const TokenWords& words,
                                                    Instant now) const;
  [[nodiscard]] Refusal wrong_token(const TokenWords& words, Instant now) const;

  const ServerCatalogue* catalogue_;
  const char* no_room_ = nullptr;  ///< why there is none for this client
  TokenCount token_count_;
  Silence silence_;
};

}  // namespace aucast::protocol
