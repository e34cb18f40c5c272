#include "client/net/server_connection.h"

#include <utility>

namespace aucast::net {

using playback::EndReason;
using Why = link::Ending::Why;

ServerConnection::ServerConnection(SharedReader& reader, std::string peer, Hooks hooks,
                                   Events events)
    : reader_(reader),
      peer_(std::move(peer)),
      hooks_(std::move(hooks)),
      events_(std::move(events)) {}

ServerConnection::~ServerConnection() {
  drop_link();
}

void ServerConnection::begin(std::shared_ptr<link::Link> link) {
  link_ = std::move(link);
  link_->start(*this);
}

void ServerConnection::fail(const std::string& reason, bool final) {
  carry_out(reader_.with([&](AuReader& reader) {
    return final ? reader.refused(EndReason::Refused, reason)
                 : reader.unreachable("cannot reach " + peer_ + ": " + reason);
  }));
}

void ServerConnection::on_open() {
  open_ = true;
  carry_out(reader_.with(
      [&](AuReader& reader) { return reader.connected(link_->now(), link_->round_trip()); }));
}

void ServerConnection::on_bytes(std::string_view bytes) {
  carry_out(reader_.with([&](AuReader& reader) { return reader.received(bytes, link_->now()); }));
}

void ServerConnection::on_peer_end() {
  lose({});
}

/// The reader is told only when it has taken what came before.
void ServerConnection::lose(std::string broke) {
  peer_ended_ = true;
  broke_ = std::move(broke);
  carry_out({});
}

void ServerConnection::on_time() {
  carry_out(reader_.with([&](AuReader& reader) { return reader.time(link_->now()); }));
}

void ServerConnection::on_closed(const link::Ending& ending) {
  if (leaving_) {
    drop_link();
    over_ = true;
    events_.over();
  } else if (ending.why == Why::NotTls || ending.why == Why::Untrusted) {
    const bool speaks_tls = ending.why == Why::Untrusted;
    carry_out(reader_.with([&](AuReader& reader) {
      return reader.refused(speaks_tls ? EndReason::Refused : EndReason::ProtocolError,
                            ending.reason);
    }));
  } else if (!open_) {
    fail(ending.reason + (ending.why == Why::NotMade ? "" : "; does it speak TLS?"), false);
  } else {
    link_over_ = true;
    lose(ending.reason);
  }
}

void ServerConnection::speak(Instant now) {
  if (!open_ || leaving_) return;
  carry_out(reader_.with([&](AuReader& reader) { return reader.speak(now); }));
}

void ServerConnection::leave() {
  if (over_ || leaving_) return;
  if (!open_ || link_over_) {
    drop_link();
    over_ = true;
    events_.over();
    return;
  }
  leaving_ = true;
  send(reader_.with([](AuReader& reader) { return reader.farewell(); }));
  link_->finish();
}

void ServerConnection::carry_out(const Reaction& reaction) {
  if (!reaction.send.empty()) send(reaction.send);
  switch (reaction.next) {
    case Reaction::Next::GoOn: {
      const auto [wants, deadline] = reader_.with([](const AuReader& reader) {
        return std::pair(reader.wants_bytes(), reader.deadline());
      });
      // What the peer said before its end may still wait for room.
      if (wants && std::exchange(peer_ended_, false)) {
        carry_out(
            reader_.with([&](AuReader& reader) { return reader.closed(link_->now(), broke_); }));
        return;
      }
      link_->set_reading(wants);
      link_->wake_at(deadline);
      break;
    }
    case Reaction::Next::Reconnect:
    case Reaction::Next::ReconnectLater:
      drop_link();
      hooks_.dial(reaction.retry_after);
      break;
    case Reaction::Next::Close:
      drop_link();
      over_ = true;
      events_.over();
      break;
  }
  if (reaction.changed) events_.changed();
}

void ServerConnection::send(std::string_view words) {
  reader_.with([&words](AuReader& reader) { reader.note_sent(words.size()); });
  link_->write(words);
}

void ServerConnection::drop_link() {
  open_ = false;
  link_over_ = false;
  peer_ended_ = false;
  if (link_) link_->close();
  link_.reset();
}

}  // namespace aucast::net
