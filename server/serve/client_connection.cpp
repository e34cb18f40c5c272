#include "server/serve/client_connection.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "common/earlier.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/limits.h"
#include "server/settings/limits.h"

namespace aucast::server {

using Why = protocol::CloseConnection::Why;

ClientConnection::ClientConnection(std::shared_ptr<link::Link> link,
                                   std::shared_ptr<const protocol::ServerCatalogue> catalogue,
                                   Settings settings, OnClosed on_closed)
    : link_(std::move(link)),
      catalogue_(std::move(catalogue)),
      settings_(std::move(settings)),
      on_closed_(std::move(on_closed)) {
  record_.number = settings_.number;
  record_.peer = settings_.peer;
}

ClientConnection::~ClientConnection() {
  if (link_) link_->close();
}

void ClientConnection::start() {
  say(spdlog::level::info, "client {} {}: connected", record_.number, record_.peer);
  link_->start(*this);
}

void ClientConnection::take_over(std::string_view bytes) {
  link_->hand_over(*this);
  on_open();
  on_bytes(bytes);
}

void ClientConnection::on_open() {
  session_.emplace(*catalogue_, link_->round_trip(), link_->now(), settings_.admission,
                   settings_.token_count, settings_.silence);
  go_on();
}

void ClientConnection::on_bytes(std::string_view bytes) {
  const auto alive = shared_from_this();
  owed_since_.reset();
  carry_out(session_->on_bytes(bytes, link_->now()));
  go_on();
}

void ClientConnection::on_peer_end() {
  const auto alive = shared_from_this();
  carry_out(session_->on_peer_end(link_->now()));
  go_on();
}

void ClientConnection::on_room() {
  const auto alive = shared_from_this();
  go_on();
}

void ClientConnection::on_moment() {
  if (!session_ || !goes_on()) return;
  carry_out(session_->on_moment(link_->now()));
  go_on();
}

void ClientConnection::on_voice() {
  if (!session_ || !goes_on()) return;
  auto events = session_->on_voice(link_->now());
  if (events.empty()) return;
  carry_out(std::move(events));
  go_on();
}

void ClientConnection::on_time() {
  const auto alive = shared_from_this();
  const Instant now = link_->now();
  if (const auto due = session_->deadline(); due && now >= *due) {
    carry_out(session_->on_time(now));
  } else if (const auto patience = patience_ends(); patience && now >= *patience) {
    const std::string what = output_bytes() == 0 ? "no answer for " : "nothing was taken for ";
    finish_sending();
    note_end(EndedHere::TimedOut,
             what + std::to_string(settings_.client_timeout.count()) + " ms (--client-timeout)",
             false);
  }
  go_on();
}

void ClientConnection::on_closed(const link::Ending& ending) {
  const auto alive = shared_from_this();
  if (ending.why == link::Ending::Why::Lost) {
    spdlog::debug("client {} {}: {}", record_.number, record_.peer, ending.reason);
  }
  lose();
}

void ClientConnection::on_failure(const link::Ending& failure) {
  const bool frames = failure.why == link::Ending::Why::WebSocketFailed;
  finish_sending();
  note_end(frames ? ClientEnd(Why::ProtocolError) : EndedHere::TlsFailed, failure.reason, false);
}

void ClientConnection::stop() {
  if (!goes_on()) return;
  if (!session_) {
    note_end(Why::Stopped, "the server stops", true);
    close();
    return;
  }
  carry_out(session_->stop(link_->now()));
  go_on();
}

bool ClientConnection::send_away() {
  if (!movable()) return false;
  carry_out(session_->send_away(link_->now()));
  return true;
}

void ClientConnection::abort() {
  if (state_ == State::Closed) return;
  if (output_bytes() != 0) {
    say(spdlog::level::warn, "client {} {}: {} bytes were not taken in time", record_.number,
        record_.peer, output_bytes());
  }
  lose();
}

void ClientConnection::carry_out(std::vector<protocol::ServerEvent> events) {
  for (protocol::ServerEvent& event : events) {
    if (auto* bytes = std::get_if<protocol::SendBytes>(&event)) {
      send(bytes->bytes);
    } else if (const auto* end = std::get_if<protocol::CloseConnection>(&event)) {
      finish_sending();
      end_with(*end);
    } else if (const auto* brings = std::get_if<protocol::HandOver>(&event)) {
      hand_over(brings->hello);
    }
  }
}

/// Of a client that was told the end, the log says that it is closed when the link has drained; of
/// any other at once.
void ClientConnection::end_with(const protocol::CloseConnection& end) {
  const bool told = end.why == Why::Finished || end.why == Why::Stopped || end.why == Why::Refused;
  if (told) {
    farewell_ = end;
  } else {
    note_end(end.why, end.reason, end.why != Why::ProtocolError && end.why != Why::Refused);
  }
}

/// Ends this client and passes its link on as a publisher's.
void ClientConnection::hand_over(const protocol::HelloAsked& hello) {
  note_end(EndedHere::HandedOver, "it brings the stream '" + hello.publish + "'", true);
  record_.bytes_total = link_->wire_bytes();
  link_->wake_at(std::nullopt);
  state_ = State::Closed;
  const auto on_publisher = std::move(settings_.on_publisher);
  auto link = std::exchange(link_, nullptr);
  const auto alive = shared_from_this();
  on_closed_(record_, why_);
  on_publisher(std::move(link), hello, record_.peer);
}

/// Logs that a classic client plays the stream at another speed: a player that does not know times
/// shows a recording of 30 pictures a second at four a second.
void ClientConnection::note_pace() {
  if (session_->level() != protocol::Level::Classic || session_->recorded() == nullptr) return;
  const auto length = protocol::classic_length(*session_->recorded());
  if (!length) return;
  say(spdlog::level::info,
      "client {} {}: classic packets carry no times: at {} ms a keyframe the stream "
      "takes {:.0f} s; --live keeps its pace",
      record_.number, record_.peer, protocol::kDefaultKeyframeTime.count(), seconds(*length));
}

void ClientConnection::send(std::string_view bytes) {
  if (!sending_since_ && session_->sent().keyframes > 0) {
    sending_since_ = link_->now();
    note_pace();
  }
  if (settings_.batch.count() == 0) {
    link_->write(bytes);
  } else {
    gathered_ += bytes;
  }
}

void ClientConnection::flush() {
  if (gathered_.empty() || gathers()) return;
  link_->write(gathered_);
  gathered_.clear();
}

/// Whether bytes wait for more before they are written. The first packet, for which a player waits,
/// and the last bytes do not.
bool ClientConnection::gathers() {
  const bool may = goes_on() && session_->sent().keyframes > 1 && gathered_.size() < kBatchBytesMax;
  if (!may) {
    gathered_until_.reset();
    return false;
  }
  const Instant now = link_->now();
  if (!gathered_until_) gathered_until_ = now + settings_.batch;
  if (now < *gathered_until_) return true;
  gathered_until_.reset();
  return false;
}

/// The last byte was written: from here on the link drains.
void ClientConnection::finish_sending() {
  if (!goes_on()) return;
  state_ = State::Draining;
  if (sending_since_) record_.send_time = link_->now() - *sending_since_;
  flush();
  link_->finish();
}

void ClientConnection::note_end(ClientEnd end_reason, std::string_view reason, bool in_order) {
  if (noted()) return;
  state_ = State::Noted;
  record_ = so_far();
  record_.end_reason = end_reason;
  const std::string_view ended = name(end_reason);
  why_ = reason.empty() ? ended : reason;
  say(in_order ? spdlog::level::info : spdlog::level::warn,
      "client {} {}: closed: {}{}{} ({}, {} in {:.3f} s)", record_.number, record_.peer, ended,
      reason.empty() ? "" : ": ", reason, counted(record_.sent.keyframes, "keyframe"),
      counted(record_.sent.payload_bytes, "byte"), seconds(record_.send_time));
}

/// Nothing can be sent any more.
void ClientConnection::lose() {
  if (farewell_) {
    note_end(farewell_->why, farewell_->reason, farewell_->why != Why::Refused);
  } else if (!noted() && session_) {
    carry_out(session_->on_lost(link_->now()));
  }
  if (!noted()) note_end(Why::PeerGone, "the connection was lost", true);
  close();
}

void ClientConnection::close() {
  if (state_ == State::Closed) return;
  state_ = State::Closed;
  record_.bytes_total = link_->wire_bytes();
  link_->close();
  on_closed_(record_, why_);
}

ClientRecord ClientConnection::so_far() const {
  ClientRecord record = record_;
  if (link_) record.bytes_total = link_->wire_bytes();
  if (!session_) return record;
  record.level = static_cast<int>(session_->level());
  record.stream = std::string(session_->stream_name());
  record.sent = session_->sent();
  return record;
}

std::size_t ClientConnection::output_bytes() const {
  return link_->unsent_bytes() + gathered_.size();
}

/// Does whatever can be done next; called at the end of every call from outside.
void ClientConnection::go_on() {
  if (!goes_on()) return;
  flush();
  do {
    carry_out(session_->set_blocked(link_->blocked(), link_->now()));
    if (!goes_on()) return;
    flush();
  } while (session_->blocked() && !link_->blocked());
  const std::optional<Instant> patience = earlier(session_->deadline(), patience_ends());
  link_->wake_at(earlier(patience, gathered_until_));
}

/// When --client-timeout ends: for an answer, counted from the client's last bytes, or for output,
/// counted from the last byte that was taken. A paused client owes nothing.
std::optional<Instant> ClientConnection::patience_ends() {
  if (settings_.client_timeout.count() == 0) return std::nullopt;
  const bool owes = session_->awaiting_answer();
  if (!owes) owed_since_.reset();
  if (owes && !owed_since_) owed_since_ = link_->now();
  // Who has sent all answers beforehand owes none, and is blocked when it takes nothing.
  const bool takes = session_->live() || (session_->blocked() && !owes && !session_->paused());
  const auto stuck = takes ? link_->stuck_since() : std::nullopt;
  if (!owed_since_ && !stuck) return std::nullopt;
  return std::min(owed_since_.value_or(Instant::max()), stuck.value_or(Instant::max())) +
         settings_.client_timeout;
}

}  // namespace aucast::server
