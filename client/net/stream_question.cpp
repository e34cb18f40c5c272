#include "client/net/stream_question.h"

#include <utility>
#include <variant>

#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::net {

StreamQuestion::StreamQuestion(Terms terms, Answered answered)
    : terms_(std::move(terms)), answered_(std::move(answered)) {}

StreamQuestion::~StreamQuestion() {
  if (link_) link_->close();
}

void StreamQuestion::ask(std::shared_ptr<link::Link> link) {
  link_ = std::move(link);
  link_->start(*this);
}

void StreamQuestion::abandon(const std::string& why) {
  end(Error{ErrorKind::Network, terms_.server + ": " + why});
}

void StreamQuestion::on_open() {
  link_->wake_at(terms_.until);
  link_->write(protocol::encode(protocol::StreamsAsked{terms_.token, true}));
}

void StreamQuestion::on_bytes(std::string_view bytes) {
  const auto packet = decoder_.next(bytes);
  if (!packet) {
    if (decoder_.error()) {
      abandon("the server sent what is not the protocol: " + decoder_.error()->reason +
              "; is it an au-transmitter?");
    }
    return;
  }
  if (const auto* list = std::get_if<protocol::StreamList>(&*packet)) {
    end(*list);
  } else if (const auto* refused = std::get_if<protocol::ErrorReply>(&*packet)) {
    abandon("refused: " + std::to_string(refused->code) + " " + escaped(refused->text, 200));
  } else {
    abandon("answered without a list of its streams: it may be a classic server, with one");
  }
}

void StreamQuestion::on_peer_end() {
  abandon("ended the connection without a list of its streams");
}

void StreamQuestion::on_time() {
  abandon("no answer in time" + (terms_.remedy.empty() ? "" : "; " + terms_.remedy));
}

void StreamQuestion::on_closed(const link::Ending& ending) {
  if (ending.why == link::Ending::Why::Lost) {
    on_peer_end();
  } else {
    abandon(ending.reason);
  }
}

void StreamQuestion::end(Result<protocol::StreamList> result) {
  if (!answered_) return;
  if (link_) link_->close();
  std::exchange(answered_, nullptr)(std::move(result));
}

}  // namespace aucast::net
