#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "common/link/link.h"
#include "common/result.h"
#include "common/time.h"
#include "protocol/decoder.h"
#include "protocol/packet.h"

namespace aucast::net {

/// Asks a server which streams it has and what it says about each: one question over one link.
/// `answered` is called once, and never from within a call of this object's functions, except
/// abandon().
/// Thread: that of the link.
class StreamQuestion final : public link::LinkUser {
 public:
  using Answered = std::function<void(Result<protocol::StreamList>)>;

  struct Terms {
    std::string server;    ///< its name in messages
    std::string token{};   ///< empty: none
    Instant until{};       ///< if no answer has come by then, the question fails
    std::string remedy{};  ///< what the user can do about that failure, as a clause; empty: nothing
  };
  StreamQuestion(Terms terms, Answered answered);
  ~StreamQuestion() override;
  StreamQuestion(const StreamQuestion&) = delete;
  StreamQuestion& operator=(const StreamQuestion&) = delete;

  void ask(std::shared_ptr<link::Link> link);
  /// No link could be made: the answer is a Network error with that reason.
  void abandon(const std::string& why);

 private:
  void on_open() override;
  void on_bytes(std::string_view bytes) override;
  void on_peer_end() override;
  void on_time() override;
  void on_closed(const link::Ending& ending) override;
  void end(Result<protocol::StreamList> result);

  const Terms terms_;
  Answered answered_;  ///< empty once it was called
  std::shared_ptr<link::Link> link_;
  protocol::ServerPacketDecoder decoder_;
};

}  // namespace aucast::net
