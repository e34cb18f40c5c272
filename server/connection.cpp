#include "server/connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <utility>
#include <variant>

#include <asio/buffer.hpp>

#include "common/log.h"
#include "common/text.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

Instant now() {
  return std::chrono::steady_clock::now();
}

/// Finds a host that vanished without a word within a minute, which nothing else would while the
/// client is paused.
void find_the_dead(tcp::socket& socket) {
  std::error_code ignored;
  socket.set_option(asio::socket_base::keep_alive(true), ignored);
  const auto set = [&socket](int option, int value) {
    ::setsockopt(socket.native_handle(), IPPROTO_TCP, option, &value, sizeof(value));
  };
  set(TCP_KEEPIDLE, 30);
  set(TCP_KEEPINTVL, 10);
  set(TCP_KEEPCNT, 3);
}

/// The connection's smoothed round trip; zero when the system does not tell.
Duration round_trip(tcp::socket& socket) {
  tcp_info info{};
  socklen_t length = sizeof(info);
  if (::getsockopt(socket.native_handle(), IPPROTO_TCP, TCP_INFO, &info, &length) != 0) return {};
  return std::chrono::microseconds(info.tcpi_rtt);
}

double seconds(Duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

Connection::Connection(tcp::socket socket, const protocol::ServerCatalogue& catalogue,
                       Settings settings, OnClosed on_closed)
    : socket_(std::move(socket)),
      timer_(socket_.get_executor()),
      settings_(std::move(settings)),
      on_closed_(std::move(on_closed)),
      session_(catalogue, round_trip(socket_), now()) {
  record_.number = settings_.number;
  record_.peer = settings_.peer;
}

void Connection::start() {
  spdlog::info("client {} {}: connected", record_.number, record_.peer);
  std::error_code ignored;
  // Stop-and-wait would otherwise wait for the peer's delayed acknowledgement at every packet.
  socket_.set_option(tcp::no_delay(true), ignored);
  find_the_dead(socket_);
  go_on();
}

void Connection::stop() {
  if (finished_ || lingering_) return;
  carry_out(session_.stop(now()));
  go_on();
}

void Connection::abort() {
  if (finished_) return;
  if (!output_done()) {
    spdlog::warn("client {} {}: {} bytes were not taken in time", record_.number, record_.peer,
                 output_bytes());
  }
  if (!lingering_) carry_out(session_.on_lost(now()));
  finish();
}

void Connection::carry_out(std::vector<protocol::ServerEvent> events) {
  for (protocol::ServerEvent& event : events) {
    if (auto* send = std::get_if<protocol::SendBytes>(&event)) {
      queue(std::move(send->bytes));
    } else if (std::holds_alternative<protocol::ShutdownSending>(event)) {
      shut_wanted_ = true;
    } else if (const auto* close = std::get_if<protocol::CloseConnection>(&event)) {
      const bool in_order = close->why != protocol::CloseConnection::Why::ProtocolError &&
                            close->why != protocol::CloseConnection::Why::Refused;
      session_closed(protocol::name(close->why), close->reason, in_order);
    }
  }
  measure_sending();
}

void Connection::queue(std::string bytes) {
  if (queued_.empty()) {
    queued_ = std::move(bytes);
  } else {
    queued_ += bytes;
  }
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
  shut_wanted_ = true;
  linger_until_ = now() + protocol::kDrainTimeMax;
  measure_sending();
  record_.level = static_cast<int>(session_.level());
  record_.stream = std::string(session_.stream_name());
  record_.packets = session_.packets_sent();
  record_.bytes = session_.payload_bytes();
  record_.end_reason = std::string(end_reason);
  spdlog::log(in_order ? spdlog::level::info : spdlog::level::warn,
              "client {} {}: closed: {}{}{} ({} packets, {} bytes in {:.3f} s)", record_.number,
              record_.peer, end_reason, reason.empty() ? "" : ": ", reason, record_.packets,
              record_.bytes, seconds(record_.send_time));
}

/// Starts whatever can be done next; called at the end of every handler.
void Connection::go_on() {
  if (finished_) return;
  write();
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
  if (reading_ || peer_ended_ || output_bytes() >= kOutputBytesMax) return;
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
    peer_ended_ = true;
    if (!lingering_) carry_out(session_.on_peer_end(now()));
  } else if (error) {
    lost(error);
    return;
  } else if (lingering_) {
    drop(bytes);
  } else {
    owed_since_.reset();
    carry_out(session_.on_bytes({input_.data(), bytes}, now()));
    // The session has drained by itself: there is no second draining.
    if (lingering_ && shut_done_) {
      finish();
      return;
    }
  }
  go_on();
}

void Connection::drop(std::size_t bytes) {
  dropped_bytes_ += bytes;
  if (dropped_bytes_ > protocol::kDrainBytesMax) finish();
}

void Connection::write() {
  if (!writing_.empty() || queued_.empty()) return;
  writing_ = std::exchange(queued_, {});
  written_ = 0;
  on_write({}, 0);
}

void Connection::on_write(const std::error_code& error, std::size_t bytes) {
  if (finished_) return;
  if (error) {
    lost(error);
    return;
  }
  written_ += bytes;
  record_.bytes_total += bytes;
  if (bytes > 0) linger_until_ = now() + protocol::kDrainTimeMax;
  if (written_ == writing_.size()) {
    writing_.clear();
    go_on();
    return;
  }
  socket_.async_write_some(
      asio::buffer(writing_.data() + written_, writing_.size() - written_),
      [self = shared_from_this()](const std::error_code& failure, std::size_t sent) {
        self->on_write(failure, sent);
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
  return writing_.size() - std::min(written_, writing_.size()) + queued_.size();
}

/// When --client-timeout runs out. Anything the client says starts the wait anew; a paused one owes
/// nothing.
std::optional<Instant> Connection::answer_deadline() {
  if (settings_.client_timeout.count() == 0) return std::nullopt;
  if (!session_.awaiting_answer() || session_.paused()) {
    owed_since_.reset();
    return std::nullopt;
  }
  if (!owed_since_) owed_since_ = now();
  return *owed_since_ + settings_.client_timeout;
}

void Connection::arm_timer() {
  std::optional<Instant> next;
  if (lingering_) {
    next = linger_until_;
  } else {
    next = session_.deadline();
    const auto answer = answer_deadline();
    if (answer && (!next || *answer < *next)) next = answer;
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
  } else if (const auto due = session_.deadline(); due && moment >= *due) {
    carry_out(session_.on_time(moment));
    if (lingering_ && shut_done_) finish();
  } else if (const auto answer = answer_deadline(); answer && moment >= *answer) {
    session_closed("timed out",
                   "no answer for " + std::to_string(settings_.client_timeout.count()) +
                       " ms (--client-timeout)",
                   false);
  }
  go_on();
}

}  // namespace aucast::server
