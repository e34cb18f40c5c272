#include "server/serve/connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <utility>
#include <variant>

#include <asio/buffer.hpp>

#include "common/log.h"
#include "common/tcp.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

Instant now() {
  return std::chrono::steady_clock::now();
}

/// What lies in the system's buffers for a client that is slow cannot be replaced by what is newer.
void limit_unsent(tcp::socket& socket, int bytes) {
  if (bytes == 0) return;
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &bytes, sizeof(bytes));
}

double seconds(Duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

Connection::Connection(tcp::socket socket,
                       std::shared_ptr<const protocol::ServerCatalogue> catalogue,
                       Settings settings, OnClosed on_closed)
    : socket_(std::move(socket)),
      catalogue_(std::move(catalogue)),
      session_(*catalogue_, round_trip(socket_.native_handle()), now(), settings.admission),
      settings_(std::move(settings)),
      timer_(socket_.get_executor()),
      on_closed_(std::move(on_closed)) {
  if (settings_.tls) {
    tls_ = std::make_unique<tls::Channel>(*settings_.tls);
    settings_.tls.reset();
    handshake_until_ = now() + protocol::kTlsHandshakeTimeMax;
  }
  record_.number = settings_.number;
  record_.peer = settings_.peer;
}

void Connection::start() {
  settings_.log->say(now(), spdlog::level::info, "client {} {}: connected", record_.number,
                     record_.peer);
  std::error_code ignored;
  // Stop-and-wait would otherwise wait for the peer's delayed acknowledgement at every packet.
  socket_.set_option(tcp::no_delay(true), ignored);
  socket_.non_blocking(true, ignored);
  find_vanished_peer(socket_.native_handle(),
                     {protocol::kKeepAliveIdle, protocol::kKeepAliveInterval,
                      protocol::kKeepAliveProbes, protocol::kUnansweredTimeMax});
  limit_unsent(socket_, settings_.unsent_bytes_max);
  go_on();
}

void Connection::on_moment() {
  if (finished_ || lingering_) return;
  carry_out(session_.on_moment(now()));
  go_on();
}

void Connection::fetch_ahead() const {
  constexpr std::size_t kCacheLine = 64;
  const char* const begin = reinterpret_cast<const char*>(this);
  const char* const end = reinterpret_cast<const char*>(&timer_);
  for (const char* line = begin; line < end; line += kCacheLine) __builtin_prefetch(line);
}

void Connection::stop() {
  if (finished_ || lingering_) return;
  if (handshaking()) {
    session_closed("stopped", "the server stops", true);
    finish();
    return;
  }
  carry_out(session_.stop(now()));
  go_on();
}

void Connection::abort() {
  if (finished_) return;
  if (!output_done()) {
    settings_.log->say(now(), spdlog::level::warn, "client {} {}: {} bytes were not taken in time",
                       record_.number, record_.peer, output_bytes());
  }
  if (!lingering_) carry_out(session_.on_lost(now()));
  finish();
}

void Connection::carry_out(std::vector<protocol::ServerEvent> events) {
  for (protocol::ServerEvent& event : events) {
    if (auto* send = std::get_if<protocol::SendBytes>(&event)) {
      queue(std::move(send->bytes));
    } else if (std::holds_alternative<protocol::ShutdownSending>(event)) {
      want_shut();
    } else if (const auto* close = std::get_if<protocol::CloseConnection>(&event)) {
      const bool in_order = close->why != protocol::CloseConnection::Why::ProtocolError &&
                            close->why != protocol::CloseConnection::Why::Refused;
      session_closed(protocol::name(close->why), close->reason, in_order);
    }
  }
  measure_sending();
}

void Connection::queue(std::string bytes) {
  if (tls_) {
    tls_->send(bytes);
    bytes = tls_->take_output();
    if (bytes.empty()) return;
  }
  append(std::move(bytes));
}

/// Bytes as they go over the wire.
void Connection::append(std::string bytes) {
  if (output_.empty()) {
    output_ = std::move(bytes);
    return;
  }
  output_.erase(0, std::exchange(written_, 0));
  output_ += bytes;
}

void Connection::measure_sending() {
  if (sending_measured_) return;
  if (!sending_since_ && session_.packets_sent() > 0) sending_since_ = now();
  if (!shut_wanted_ && !lingering_) return;
  sending_measured_ = true;
  if (sending_since_) record_.send_time = now() - *sending_since_;
}

void Connection::session_closed(std::string_view end_reason, std::string_view reason,
                                bool in_order) {
  lingering_ = true;
  want_shut();
  linger_until_ = now() + protocol::kDrainTimeMax;
  measure_sending();
  record_ = so_far();
  record_.end_reason = std::string(end_reason);
  settings_.log->say(now(), in_order ? spdlog::level::info : spdlog::level::warn,
                     "client {} {}: closed: {}{}{} ({} packets, {} bytes in {:.3f} s)",
                     record_.number, record_.peer, end_reason, reason.empty() ? "" : ": ", reason,
                     record_.packets, record_.bytes, seconds(record_.send_time));
}

ClientRecord Connection::so_far() const {
  ClientRecord record = record_;
  record.level = static_cast<int>(session_.level());
  record.stream = std::string(session_.stream_name());
  record.packets = session_.packets_sent();
  record.bytes = session_.payload_bytes();
  record.packets_merged = session_.packets_merged();
  return record;
}

/// Starts whatever can be done next; called at the end of every handler.
void Connection::go_on() {
  if (finished_) return;
  write();
  if (session_.live() && !finished_) {
    carry_out(session_.hold(awaiting_write_, now()));
    write();
  }
  if (finished_) return;
  if (shut_wanted_ && output_done()) shut_sending();
  if (lingering_ && shut_done_ && peer_ended_) {
    finish();
    return;
  }
  read();
  arm_timer();
}

void Connection::read() {
  if (reading_ || peer_ended_ || output_bytes() >= protocol::kOutputBytesMax) return;
  reading_ = true;
  socket_.async_read_some(
      asio::buffer(input_),
      [self = shared_from_this()](const std::error_code& error, std::size_t bytes) {
        self->reading_ = false;
        if (!self->finished_) self->on_read(error, bytes);
      });
}

void Connection::on_read(const std::error_code& error, std::size_t bytes) {
  if (error == asio::error::eof) {
    peer_ended();
  } else if (error) {
    lost(error);
    return;
  } else if (lingering_) {
    drop(bytes);
  } else {
    if (tls_) {
      read_tls({input_.data(), bytes});
    } else {
      hand_to_session({input_.data(), bytes});
    }
    // The session has drained by itself: there is no second draining.
    if (lingering_ && shut_done_) {
      finish();
      return;
    }
  }
  go_on();
}

void Connection::hand_to_session(std::string_view bytes) {
  owed_since_.reset();
  carry_out(session_.on_bytes(bytes, now()));
}

void Connection::peer_ended() {
  if (std::exchange(peer_ended_, true) || lingering_) return;
  if (handshaking()) {
    fail_tls("the client left within the TLS handshake", false);
  } else {
    carry_out(session_.on_peer_end(now()));
  }
}

void Connection::read_tls(std::string_view bytes) {
  const bool begun = !handshaking();
  std::string plain;
  const bool good = tls_->received(bytes, plain);
  if (!begun && !handshaking()) {
    session_ = protocol::ServerSession(*catalogue_, round_trip(socket_.native_handle()), now(),
                                       settings_.admission);
  }
  // What the channel itself has to say, the alert that explains a failure too.
  if (std::string said = tls_->take_output(); !said.empty()) append(std::move(said));
  if (!plain.empty()) hand_to_session(plain);
  if (lingering_) return;
  if (!good) {
    fail_tls(tls_->reason(), tls_->failure() == tls::Channel::Failure::NotTls);
  } else if (tls_->ended()) {
    peer_ended();
  }
}

/// `answer_plain`: the client may not even know that this is TLS, so it is told without.
void Connection::fail_tls(std::string_view reason, bool answer_plain) {
  if (answer_plain) {
    append(protocol::encode(
        protocol::ErrorReply{400, "this server speaks TLS only (face-player --tls)"}));
  }
  session_closed("tls failed", reason, false);
}

/// Nothing more is to be said: TLS has a last word of its own.
void Connection::want_shut() {
  if (std::exchange(shut_wanted_, true) || !tls_) return;
  tls_->end();
  if (std::string said = tls_->take_output(); !said.empty()) append(std::move(said));
}

void Connection::drop(std::size_t bytes) {
  dropped_bytes_ += bytes;
  if (dropped_bytes_ > protocol::kDrainBytesMax) finish();
}

/// Writes at once what the socket takes: a completion for every packet would cost more than the
/// packet.
void Connection::write() {
  if (gathers()) return;
  while (!finished_ && !awaiting_write_ && !output_done()) {
    std::error_code error;
    const std::size_t bytes = socket_.write_some(
        asio::buffer(output_.data() + written_, output_.size() - written_), error);
    if (error == asio::error::would_block || error == asio::error::try_again) {
      if (!unsent_since_) unsent_since_ = now();
      write_when_possible();
    } else if (error) {
      lost(error);
    } else {
      written_ += bytes;
      record_.bytes_total += bytes;
      stuck_since_.reset();
      unsent_since_.reset();
      if (lingering_) linger_until_ = now() + protocol::kDrainTimeMax;
    }
  }
  if (output_done()) {
    output_.clear();
    written_ = 0;
  }
}

/// Whether what there is to write waits for more. The first packet, which a player is waiting for,
/// and the last words do not.
bool Connection::gathers() {
  const bool may = settings_.batch.count() > 0 && !output_done() && !shut_wanted_ &&
                   session_.packets_sent() > 1 && output_bytes() < protocol::kBatchBytesMax;
  if (!may) {
    batch_until_.reset();
    return false;
  }
  const Instant moment = now();
  if (!batch_until_) batch_until_ = moment + settings_.batch;
  return moment < *batch_until_;
}

void Connection::write_when_possible() {
  awaiting_write_ = true;
  socket_.async_wait(tcp::socket::wait_write,
                     [self = shared_from_this()](const std::error_code& error) {
                       self->awaiting_write_ = false;
                       if (self->finished_) return;
                       if (error) {
                         self->lost(error);
                       } else {
                         self->go_on();
                       }
                     });
}

void Connection::shut_sending() {
  if (std::exchange(shut_done_, true)) return;
  std::error_code ignored;
  socket_.shutdown(tcp::socket::shutdown_send, ignored);
  linger_until_ = now() + protocol::kDrainTimeMax;
}

void Connection::lost(const std::error_code& error) {
  if (!lingering_) {
    spdlog::debug("client {} {}: {}", record_.number, record_.peer, error.message());
    carry_out(session_.on_lost(now()));
  }
  finish();
}

void Connection::finish() {
  if (std::exchange(finished_, true)) return;
  std::error_code ignored;
  timer_.cancel();
  socket_.close(ignored);
  on_closed_(record_);
}

std::size_t Connection::output_bytes() const {
  return output_.size() - written_;
}

/// When --client-timeout runs out: for an answer, which anything the client says puts off, or for
/// the output, which any byte that goes out does. A paused client owes nothing.
std::optional<Instant> Connection::patience_ends() {
  if (settings_.client_timeout.count() == 0) return std::nullopt;
  const bool owes = session_.awaiting_answer() && !session_.paused();
  const auto since = [](std::optional<Instant>& begin, bool waiting) {
    if (!waiting) begin.reset();
    if (waiting && !begin) begin = now();
    return begin;
  };
  const auto owed = since(owed_since_, owes);
  const auto stuck = since(stuck_since_, session_.live() && awaiting_write_);
  if (!owed && !stuck) return std::nullopt;
  return std::min(owed.value_or(Instant::max()), stuck.value_or(Instant::max())) +
         settings_.client_timeout;
}

void Connection::arm_timer() {
  std::optional<Instant> next;
  if (lingering_) {
    next = linger_until_;
  } else {
    next = handshaking() ? handshake_until_ : session_.deadline();
    const auto patience = patience_ends();
    if (patience && (!next || *patience < *next)) next = patience;
    if (batch_until_ && (!next || *batch_until_ < *next)) next = batch_until_;
  }
  if (next == armed_for_) return;
  armed_for_ = next;
  if (!next) {
    timer_.cancel();
    return;
  }
  timer_.expires_at(*next);
  timer_.async_wait([self = shared_from_this()](const std::error_code& error) {
    // Cancelled, or overtaken by a wait that was armed since.
    if (error || self->finished_ || !self->armed_for_ || now() < *self->armed_for_) return;
    self->armed_for_.reset();
    self->on_timer();
  });
}

void Connection::on_timer() {
  const Instant moment = now();
  if (lingering_) {
    if (moment >= linger_until_) finish();
  } else if (handshaking()) {
    if (moment >= handshake_until_) fail_tls("no TLS handshake within 10 s", true);
  } else if (const auto due = session_.deadline(); due && moment >= *due) {
    carry_out(session_.on_time(moment));
    if (lingering_ && shut_done_) finish();
  } else if (const auto patience = patience_ends(); patience && moment >= *patience) {
    session_closed("timed out",
                   std::string(output_done() ? "no answer for " : "nothing was taken for ") +
                       std::to_string(settings_.client_timeout.count()) + " ms (--client-timeout)",
                   false);
  }
  go_on();
}

}  // namespace aucast::server
