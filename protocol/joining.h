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

/// Decides whether a client is let in, and which stream it gets. Checks the client's version, token
/// and stream, and the room for it, in the right order. Sends nothing. Thread: none of its own; one
/// object for each client.
class Joining {
 public:
  struct Refusal {
    ErrorReply reply;
    /// The client is classic: close the connection without sending `reply`.
    bool silent = false;
    Duration after{};  ///< how long to wait before replying, to slow down guessing of tokens
  };
  /// A stream that is here or may still come (a refused one is a Refusal), the refusal, a publisher
  /// whose stream is accepted, or the list of streams that was asked for.
  using Answer = std::variant<StreamChoice, Refusal, HandOver, StreamList>;

  /// The catalogue must outlive it.
  Joining(const ServerCatalogue& catalogue, Admission admission, TokenCount token_count,
          Silence silence);

  [[nodiscard]] Answer hello(const HelloAsked& asked, Instant now) const;
  [[nodiscard]] Answer list(const StreamsAsked& asked, Instant now) const;
  /// For a client that sends no hello.
  [[nodiscard]] Answer classic(Instant now) const;
  /// For a client that was let in and waits for its stream: looks for the stream again. `asked`:
  /// nullopt for a classic client.
  [[nodiscard]] Answer stream_of(const std::optional<HelloAsked>& asked) const;

 private:
  struct TokenWords;

  [[nodiscard]] Answer publisher(const HelloAsked& asked, Instant now) const;
  [[nodiscard]] std::optional<Refusal> viewer_refused(std::string_view token, Instant now) const;
  [[nodiscard]] std::optional<Refusal> may_not_show(std::string_view token, const TokenWords& words,
                                                    Instant now) const;
  [[nodiscard]] Refusal wrong_token(const TokenWords& words, Instant now) const;

  const ServerCatalogue* catalogue_;
  bool owner_;                     ///< needs the owner's token to watch
  const char* no_room_ = nullptr;  ///< why there is no room for this client; null: there is
  TokenCount token_count_;
  Silence silence_;
};

}  // namespace aucast::protocol
