#include "client/net/remote_source.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include "client/net/au_reader.h"
#include "common/link/name_lookup.h"
#include "common/tcp.h"
#include "common/text.h"
#include "common/tls/channel.h"
#include "protocol/limits.h"

namespace aucast::net {
namespace {

using asio::ip::tcp;
using ErrorCode = std::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kReadBytes = 4096;

std::string peer_name(const RemoteOptions& options) {
  const std::string host = escaped(options.host);
  const bool v6 = host.find(':') != std::string::npos;
  return (v6 ? "[" + host + "]" : host) + ":" + std::to_string(options.port);
}

AuReaderOptions reader_options(const RemoteOptions& options) {
  return {peer_name(options), options.classic, options.stream,    options.connect_timeout,
          options.buffers,    options.speed,   options.reconnect, options.security.token};
}

/// "10 s", "250 ms".
std::string seconds_text(Duration time) {
  const auto ms = std::chrono::duration_cast<Milliseconds>(time).count();
  return ms % 1000 == 0 ? std::to_string(ms / 1000) + " s" : std::to_string(ms) + " ms";
}

}  // namespace

/// What the player's and the network thread both touch.
struct RemoteSource::Shared {
  explicit Shared(const RemoteOptions& options) : reader(reader_options(options)) {}

  std::atomic<std::uint64_t> bytes_sent{0};

  mutable std::mutex mutex;
  std::condition_variable news;
  // Guarded by mutex:
  AuReader reader;
  bool speak_posted = false;  // the network thread has been asked to speak() and has not yet
};

/// The socket and its thread. All members belong to that thread; post_*() may be called from
/// others.
class RemoteSource::Connection {
 public:
  Connection(Shared& shared, RemoteOptions options)
      : shared_(shared), options_(std::move(options)), peer_(peer_name(options_)) {
    thread_ = std::jthread([this] { run(); });
  }

  void post_speak() {
    asio::post(io_, [this] { speak(); });
  }
  void post_farewell() {
    asio::post(io_, [this] { begin_farewell(); });
  }

 private:
  enum class Phase : std::uint8_t { Reaching, Handshake, Open, Farewell, Closed };

  void run();
  void reach();
  void resolve();
  void try_next_address();
  void connected();
  void shake_hands();
  void open();
  [[nodiscard]] bool token_may_be_read() const;
  void read_tls(std::string_view bytes);
  void hand_to_reader(std::string_view bytes);
  void peer_ended();
  void send(std::string_view words);
  void end_reader(playback::EndReason why, const std::string& reason);
  void read();
  void on_read(const ErrorCode& failure, std::size_t size);
  void write();
  void wait_for_deadline();
  void speak();
  void begin_farewell();
  void end_sending_when_written();
  void carry_out(const Reaction& reaction);
  void reach_later(Milliseconds wait);
  void give_up(const std::string& cause, const std::string& remedy);
  void drop_socket();
  void close();
  void tell_player();

  /// Wraps a handler so that it does nothing once the socket it was made for has been dropped.
  template <typename Handler>
  auto for_this_socket(Handler handler) {
    return [this, made_for = socket_number_, handler = std::move(handler)](const ErrorCode& failure,
                                                                           auto... results) {
      if (made_for == socket_number_ && phase_ != Phase::Closed) handler(failure, results...);
    };
  }

  Shared& shared_;
  const RemoteOptions options_;
  const std::string peer_;

  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  link::NameLookup lookup_{io_};
  tcp::socket socket_{io_};
  asio::steady_timer reach_timer_{io_};     // the time for the address being tried
  asio::steady_timer session_timer_{io_};   // what the session waits for
  asio::steady_timer farewell_timer_{io_};  // for the last words

  Phase phase_ = Phase::Reaching;
  std::uint64_t socket_number_ = 0;
  Instant reach_until_{};
  std::vector<tcp::endpoint> addresses_;
  std::size_t next_address_ = 0;
  ErrorCode last_failure_;

  std::unique_ptr<tls::Channel> tls_;  ///< nothing: plain
  std::array<char, kReadBytes> incoming_{};
  bool reading_ = false;
  std::string outgoing_;  // to be written
  std::string writing_;   // being written
  std::jthread thread_;   // last: it ends before anything it uses is gone
};

void RemoteSource::Connection::run() {
  // Asio throws when the system has no thread or descriptor left for it.
  try {
    reach();
    io_.run();
  } catch (const std::system_error& failure) {
    give_up(failure.code().message(), "the system is short of threads or files");
  }
}

// === Reaching the server.

void RemoteSource::Connection::reach() {
  phase_ = Phase::Reaching;
  reach_until_ = Clock::now() + options_.connect_timeout;
  addresses_.clear();
  next_address_ = 0;
  last_failure_ = {};

  ErrorCode no_address;
  const asio::ip::address address = asio::ip::make_address(options_.host, no_address);
  if (no_address) {
    resolve();
    return;
  }
  addresses_.emplace_back(address, options_.port);
  try_next_address();
}

void RemoteSource::Connection::resolve() {
  reach_timer_.expires_at(reach_until_);
  reach_timer_.async_wait(for_this_socket([this](const ErrorCode& failure) {
    if (failure || !addresses_.empty()) return;
    give_up("its name could not be looked up within " + seconds_text(options_.connect_timeout),
            "check the network or give the address in numbers");
  }));
  lookup_.start(options_.host, options_.port,
                [this](const std::string& failure, link::Addresses found) {
                  if (!failure.empty()) {
                    give_up(failure, "check the host's name");
                    return;
                  }
                  addresses_ = std::move(found);
                  try_next_address();
                });
}

/// Every address gets an even share of the time that is left, so that one that never answers does
/// not use up what the others need.
void RemoteSource::Connection::try_next_address() {
  drop_socket();
  const auto left = reach_until_ - Clock::now();
  if (next_address_ == addresses_.size() || left <= Duration::zero()) {
    const bool late = !last_failure_ || last_failure_ == asio::error::operation_aborted;
    give_up(
        late ? "no answer within " + seconds_text(options_.connect_timeout)
             : last_failure_.message(),
        "is au-transmitter running there, on an address (--bind) that can be reached from here?");
    return;
  }
  const auto addresses_left = static_cast<Duration::rep>(addresses_.size() - next_address_);
  reach_timer_.expires_after(left / addresses_left);
  reach_timer_.async_wait(for_this_socket([this](const ErrorCode& failure) {
    if (failure || phase_ != Phase::Reaching) return;
    last_failure_ = asio::error::operation_aborted;
    try_next_address();
  }));
  socket_.async_connect(addresses_[next_address_++],
                        for_this_socket([this](const ErrorCode& failure) {
                          if (failure) {
                            last_failure_ = failure;
                            try_next_address();
                          } else {
                            connected();
                          }
                        }));
}

void RemoteSource::Connection::connected() {
  reach_timer_.cancel();
  ErrorCode ignored;
  socket_.set_option(tcp::no_delay(true), ignored);  // small packets must not wait for each other
  find_vanished_peer(socket_.native_handle(),
                     {protocol::kKeepAliveIdle, protocol::kKeepAliveInterval,
                      protocol::kKeepAliveProbes, protocol::kUnansweredTimeMax});
  if (token_may_be_read()) {
    end_reader(playback::EndReason::Refused,
               "everybody on the way could read the token; --tls, or --insecure-token");
  } else if (options_.security.tls) {
    shake_hands();
  } else {
    open();
  }
}

/// The name may have led elsewhere than to this computer.
bool RemoteSource::Connection::token_may_be_read() const {
  const Security& security = options_.security;
  if (security.token.empty() || security.tls || security.insecure_token) return false;
  ErrorCode unknown;
  const auto peer = socket_.remote_endpoint(unknown);
  return unknown || !peer.address().is_loopback();
}

void RemoteSource::Connection::shake_hands() {
  phase_ = Phase::Handshake;
  tls_ = std::make_unique<tls::Channel>(*options_.security.tls, options_.host);
  reach_timer_.expires_at(reach_until_);
  reach_timer_.async_wait(for_this_socket([this](const ErrorCode& failure) {
    if (failure || phase_ != Phase::Handshake) return;
    give_up("no TLS handshake within " + seconds_text(options_.connect_timeout),
            "does the server speak TLS?");
  }));
  outgoing_ += tls_->take_output();
  write();
  read();
}

/// The first words may be said.
void RemoteSource::Connection::open() {
  reach_timer_.cancel();
  phase_ = Phase::Open;
  Reaction reaction;
  {
    const std::lock_guard lock(shared_.mutex);
    reaction = shared_.reader.connected(Clock::now(), round_trip(socket_.native_handle()));
  }
  carry_out(reaction);
}

void RemoteSource::Connection::give_up(const std::string& cause, const std::string& remedy) {
  Reaction reaction;
  {
    const std::lock_guard lock(shared_.mutex);
    reaction = shared_.reader.unreachable("cannot reach " + peer_ + ": " + cause + "; " + remedy);
  }
  carry_out(reaction);
}

void RemoteSource::Connection::reach_later(Milliseconds wait) {
  drop_socket();
  phase_ = Phase::Reaching;
  reach_timer_.expires_after(wait);
  reach_timer_.async_wait(for_this_socket([this](const ErrorCode& failure) {
    if (!failure) reach();
  }));
}

// === An open connection.

void RemoteSource::Connection::read() {
  if (reading_) return;
  if (phase_ == Phase::Open) {
    const std::lock_guard lock(shared_.mutex);
    if (!shared_.reader.wants_bytes()) return;
  }
  reading_ = true;
  socket_.async_read_some(asio::buffer(incoming_),
                          for_this_socket([this](const ErrorCode& failure, std::size_t size) {
                            reading_ = false;
                            on_read(failure, size);
                          }));
}

void RemoteSource::Connection::on_read(const ErrorCode& failure, std::size_t size) {
  if (phase_ == Phase::Farewell) {
    // To the server's end: a socket closed with unread bytes in it would take back, by its reset,
    // the last words that the server has not read yet.
    if (failure) {
      close();
    } else {
      read();
    }
    return;
  }
  if (failure) {
    peer_ended();
  } else if (tls_) {
    read_tls({incoming_.data(), size});
  } else {
    hand_to_reader({incoming_.data(), size});
  }
}

void RemoteSource::Connection::hand_to_reader(std::string_view bytes) {
  Reaction reaction;
  {
    const std::lock_guard lock(shared_.mutex);
    reaction = shared_.reader.received(bytes, Clock::now());
  }
  carry_out(reaction);
}

void RemoteSource::Connection::peer_ended() {
  if (phase_ == Phase::Handshake) {
    give_up("the server ended the connection within the TLS handshake", "does it speak TLS?");
    return;
  }
  Reaction reaction;
  {
    const std::lock_guard lock(shared_.mutex);
    reaction = shared_.reader.closed(Clock::now());
  }
  carry_out(reaction);
}

void RemoteSource::Connection::read_tls(std::string_view bytes) {
  using Failure = tls::Channel::Failure;
  std::string plain;
  const bool good = tls_->received(bytes, plain);
  const std::uint64_t socket = socket_number_;
  // Our last part of the handshake and the hello go out in one piece.
  if (tls_->ready() && phase_ == Phase::Handshake) open();
  const auto stands = [&] { return socket == socket_number_ && phase_ != Phase::Closed; };
  if (stands() && !plain.empty()) hand_to_reader(plain);
  if (!stands()) return;
  outgoing_ += tls_->take_output();
  write();
  if (!good && tls_->failure() == Failure::Broken && phase_ == Phase::Handshake) {
    give_up("TLS cannot be agreed on: " + tls_->reason(), "does it speak TLS?");
  } else if (!good && tls_->failure() == Failure::Broken) {
    peer_ended();
  } else if (!good) {
    end_reader(tls_->failure() == Failure::NotTls ? playback::EndReason::ProtocolError
                                                  : playback::EndReason::Refused,
               tls_->reason());
  } else if (tls_->ended()) {
    peer_ended();
  } else {
    read();
  }
}

void RemoteSource::Connection::end_reader(playback::EndReason why, const std::string& reason) {
  Reaction reaction;
  {
    const std::lock_guard lock(shared_.mutex);
    reaction = shared_.reader.refused(why, reason);
  }
  carry_out(reaction);
}

void RemoteSource::Connection::send(std::string_view words) {
  shared_.bytes_sent += words.size();
  if (tls_) {
    tls_->send(words);
    outgoing_ += tls_->take_output();
  } else {
    outgoing_ += words;
  }
}

void RemoteSource::Connection::write() {
  if (!writing_.empty() || outgoing_.empty()) return;
  writing_ = std::exchange(outgoing_, {});
  asio::async_write(socket_, asio::buffer(writing_),
                    for_this_socket([this](const ErrorCode& failure, std::size_t /*size*/) {
                      writing_.clear();
                      // A broken connection shows when reading, after what still can be read.
                      if (failure) outgoing_.clear();
                      write();
                      if (phase_ == Phase::Farewell) end_sending_when_written();
                    }));
}

void RemoteSource::Connection::wait_for_deadline() {
  std::optional<Instant> deadline;
  {
    const std::lock_guard lock(shared_.mutex);
    deadline = shared_.reader.deadline();
  }
  session_timer_.cancel();
  if (!deadline) return;
  session_timer_.expires_at(*deadline);
  session_timer_.async_wait(for_this_socket([this](const ErrorCode& failure) {
    if (failure || phase_ != Phase::Open) return;
    Reaction reaction;
    {
      const std::lock_guard lock(shared_.mutex);
      reaction = shared_.reader.time(Clock::now());
    }
    carry_out(reaction);
  }));
}

void RemoteSource::Connection::speak() {
  Reaction reaction;
  {
    const std::lock_guard lock(shared_.mutex);
    shared_.speak_posted = false;
    if (phase_ != Phase::Open) return;
    reaction = shared_.reader.speak(Clock::now());
  }
  carry_out(reaction);
}

void RemoteSource::Connection::carry_out(const Reaction& reaction) {
  send(reaction.send);
  switch (reaction.next) {
    case Reaction::Next::GoOn:
      write();
      read();
      wait_for_deadline();
      break;
    case Reaction::Next::Reconnect:
      drop_socket();
      reach();
      break;
    case Reaction::Next::ReconnectLater:
      reach_later(reaction.retry_after);
      break;
    case Reaction::Next::Close:
      close();
      break;
  }
  if (reaction.changed) tell_player();
}

// === Leaving.

void RemoteSource::Connection::begin_farewell() {
  if (phase_ == Phase::Farewell) return;
  if (phase_ != Phase::Open) {
    close();
    return;
  }
  phase_ = Phase::Farewell;
  session_timer_.cancel();
  farewell_timer_.expires_after(protocol::kFarewellTimeMax);
  farewell_timer_.async_wait(for_this_socket([this](const ErrorCode& failure) {
    if (!failure) close();
  }));
  std::string words;
  {
    const std::lock_guard lock(shared_.mutex);
    words = shared_.reader.farewell();
  }
  send(words);
  if (tls_) {
    tls_->end();
    outgoing_ += tls_->take_output();
  }
  write();
  end_sending_when_written();
  read();
}

void RemoteSource::Connection::end_sending_when_written() {
  if (!writing_.empty() || !outgoing_.empty()) return;
  ErrorCode ignored;
  socket_.shutdown(tcp::socket::shutdown_send, ignored);
}

void RemoteSource::Connection::drop_socket() {
  ++socket_number_;
  reading_ = false;
  outgoing_.clear();
  writing_.clear();
  tls_.reset();
  lookup_.cancel();
  ErrorCode ignored;
  socket_.close(ignored);
  reach_timer_.cancel();
  session_timer_.cancel();
}

void RemoteSource::Connection::close() {
  phase_ = Phase::Closed;
  farewell_timer_.cancel();
  drop_socket();
  work_.reset();
}

void RemoteSource::Connection::tell_player() {
  shared_.news.notify_all();
  if (options_.wakeup) options_.wakeup();
}

// === The player's side.

RemoteSource::RemoteSource(RemoteOptions options)
    : shared_(std::make_unique<Shared>(options)),
      connection_(std::make_unique<Connection>(*shared_, std::move(options))) {}

RemoteSource::~RemoteSource() {
  stop();
}

std::optional<playback::TimedAus> RemoteSource::take() {
  std::optional<playback::TimedAus> keyframe;
  bool speak = false;
  {
    const std::lock_guard lock(shared_->mutex);
    keyframe = shared_->reader.take();
    speak = !shared_->speak_posted && shared_->reader.has_words();
    shared_->speak_posted |= speak;
  }
  if (speak) connection_->post_speak();
  return keyframe;
}

bool RemoteSource::ready() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->reader.ready();
}

bool RemoteSource::wait_until(Instant until) {
  std::unique_lock lock(shared_->mutex);
  return shared_->news.wait_until(lock, until, [this] { return shared_->reader.ready(); });
}

playback::SourceStatus RemoteSource::status() const {
  const std::lock_guard lock(shared_->mutex);
  playback::SourceStatus status = shared_->reader.status();
  status.bytes_sent = shared_->bytes_sent;
  return status;
}

void RemoteSource::stop() {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->reader.leave();
  }
  connection_->post_farewell();
}

void RemoteSource::pause() {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->reader.set_paused(true);
  }
  connection_->post_speak();
}

void RemoteSource::resume() {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->reader.set_paused(false);
  }
  connection_->post_speak();
}

}  // namespace aucast::net
