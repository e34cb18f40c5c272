#include "common/link/tcp_link.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>

namespace aucast::link {
namespace {

using asio::ip::tcp;
using std::chrono::steady_clock;

void set_option(int socket, int level, int option, int value) {
  static_cast<void>(::setsockopt(socket, level, option, &value, sizeof value));
}

/// Lets the system end the connection when the peer has vanished without closing it.
void find_vanished_peer(int socket, const Limits& limits) {
  const auto seconds = [](Milliseconds time) {
    return static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(time).count());
  };
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, seconds(limits.keep_alive_idle));
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, seconds(limits.keep_alive_interval));
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, limits.keep_alive_probes);
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT,
             static_cast<int>(limits.unanswered_time.count()));
}

/// Asio's handlers keep the link alive.
class TcpLink final : public Link, public std::enable_shared_from_this<TcpLink> {
 public:
  TcpLink(tcp::socket socket, const Limits& limits, int held_back_max)
      : socket_(std::move(socket)), timer_(socket_.get_executor()), limits_(limits) {
    std::error_code ignored;
    socket_.non_blocking(true, ignored);
    // Stop-and-wait would otherwise wait for the peer's delayed acknowledgement at every packet.
    socket_.set_option(tcp::no_delay(true), ignored);
    const int descriptor = socket_.native_handle();
    find_vanished_peer(descriptor, limits_);
    // What the system holds for a slow peer cannot be replaced by what is newer.
    if (held_back_max != 0) {
      set_option(descriptor, IPPROTO_TCP, TCP_NOTSENT_LOWAT, held_back_max);
    }
  }

  void start(LinkUser& user) override {
    user_ = &user;
    user_->on_open();
    go_on();
  }

  void hand_over(LinkUser& user) override { user_ = &user; }

  /// Written here and not by a completion, which would cost more than a packet does.
  void write(std::string_view bytes) override {
    if (state_ != State::Open || outgoing_ == Outgoing::Broken) return;
    if (output_.empty()) bytes.remove_prefix(send(bytes));
    if (bytes.empty() || outgoing_ == Outgoing::Broken) return;
    output_.erase(0, std::exchange(sent_, 0));
    output_ += bytes;
  }

  void finish() override {
    if (state_ != State::Open) return;
    state_ = State::Finishing;
    drain_until_ = now() + limits_.drain_time;
    shut_when_sent();
    read();
    arm_timer();
    if (drained()) {
      asio::post(socket_.get_executor(), [self = shared_from_this()] { self->go_on(); });
    }
  }

  void close() override {
    user_ = nullptr;
    if (std::exchange(state_, State::Closed) == State::Closed) return;
    std::error_code ignored;
    timer_.cancel();
    socket_.close(ignored);
  }

  void set_reading(bool reading) override {
    reading_wanted_ = reading;
    if (user_ != nullptr) read();
  }

  void wake_at(std::optional<Instant> when) override {
    wake_at_ = when;
    arm_timer();
  }

  [[nodiscard]] Instant now() const override { return steady_clock::now(); }

  [[nodiscard]] Duration round_trip() const override {
    tcp_info info{};
    socklen_t length = sizeof info;
    const int descriptor = const_cast<tcp::socket&>(socket_).native_handle();
    if (::getsockopt(descriptor, IPPROTO_TCP, TCP_INFO, &info, &length) != 0) return {};
    return std::chrono::microseconds(info.tcpi_rtt);
  }

  [[nodiscard]] bool blocked() const override { return outgoing_ == Outgoing::Blocked; }
  [[nodiscard]] std::optional<Instant> stuck_since() const override { return stuck_since_; }
  [[nodiscard]] std::size_t unsent_bytes() const override { return output_.size() - sent_; }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return wire_bytes_; }

 private:
  enum class State : std::uint8_t {
    Open,
    Finishing,  ///< sends what waits
    Shut,       ///< the sending side is shut; waits for the peer to end its own
    Closed,
  };
  enum class Incoming : std::uint8_t {
    Idle,
    Reading,  ///< a read is under way
    Ended,    ///< by the peer
  };
  enum class Outgoing : std::uint8_t {
    Free,
    Blocked,  ///< a wait for room is under way
    Broken,   ///< by a write; reported after the running call has returned
  };

  [[nodiscard]] bool closed() const { return state_ == State::Closed; }
  [[nodiscard]] bool finishing() const {
    return state_ == State::Finishing || state_ == State::Shut;
  }

  /// Whatever can be done next; called at the end of every handler.
  void go_on() {
    if (closed()) return;
    shut_when_sent();
    if (drained()) {
      end({});
      return;
    }
    read();
    arm_timer();
  }

  [[nodiscard]] bool drained() const {
    return state_ == State::Shut && incoming_ == Incoming::Ended;
  }

  void shut_when_sent() {
    if (state_ != State::Finishing || unsent_bytes() != 0) return;
    state_ = State::Shut;
    std::error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    drain_until_ = now() + limits_.drain_time;
  }

  void read() {
    if (closed() || incoming_ != Incoming::Idle || unsent_bytes() >= limits_.unsent_bytes) return;
    if (!reading_wanted_ && !finishing()) return;
    incoming_ = Incoming::Reading;
    socket_.async_read_some(
        asio::buffer(input_),
        [self = shared_from_this()](const std::error_code& error, std::size_t size) {
          self->incoming_ = Incoming::Idle;
          if (self->closed()) return;
          self->on_read(error, size);
          self->go_on();
        });
  }

  void on_read(const std::error_code& error, std::size_t size) {
    if (error == asio::error::eof) {
      incoming_ = Incoming::Ended;
      await_loss();
      if (!finishing()) user_->on_peer_end();
    } else if (error) {
      lose(error);
    } else if (!finishing()) {
      user_->on_bytes({input_.data(), size});
    } else if ((dropped_bytes_ += size) > limits_.drain_bytes) {
      end({});
    }
  }

  /// After the peer's end no read can fail any more: that it has vanished shows here, even while
  /// there is nothing to send.
  void await_loss() {
    socket_.async_wait(tcp::socket::wait_error,
                       [self = shared_from_this()](const std::error_code& cancelled) {
                         if (cancelled || self->closed()) return;
                         if (const auto error = self->error_of_socket()) self->lose(error);
                       });
  }

  [[nodiscard]] std::error_code error_of_socket() {
    int error = 0;
    socklen_t length = sizeof error;
    ::getsockopt(socket_.native_handle(), SOL_SOCKET, SO_ERROR, &error, &length);
    return {error, asio::error::get_system_category()};
  }

  /// Returns how many bytes were taken: all of them when the connection is broken.
  std::size_t send(std::string_view bytes) {
    std::size_t taken = 0;
    while (taken < bytes.size() && outgoing_ == Outgoing::Free) {
      std::error_code error;
      const std::size_t size =
          socket_.write_some(asio::buffer(bytes.data() + taken, bytes.size() - taken), error);
      if (error == asio::error::would_block || error == asio::error::try_again) {
        await_room();
      } else if (error) {
        outgoing_ = Outgoing::Broken;
        asio::post(socket_.get_executor(),
                   [self = shared_from_this(), error] { self->lose(error); });
        return bytes.size();
      } else {
        taken += size;
        wire_bytes_ += size;
        stuck_since_.reset();
        if (finishing()) drain_until_ = now() + limits_.drain_time;
      }
    }
    return taken;
  }

  void await_room() {
    outgoing_ = Outgoing::Blocked;
    if (!stuck_since_) stuck_since_ = now();
    socket_.async_wait(tcp::socket::wait_write,
                       [self = shared_from_this()](const std::error_code& error) {
                         self->outgoing_ = Outgoing::Free;
                         if (self->closed()) return;
                         self->on_writable(error);
                         self->go_on();
                       });
  }

  void on_writable(const std::error_code& error) {
    if (error) {
      lose(error);
      return;
    }
    sent_ += send(std::string_view(output_).substr(sent_));
    if (sent_ < output_.size()) return;
    output_.clear();
    sent_ = 0;
    // What broke just now is told next; there is no room.
    if (!finishing() && outgoing_ != Outgoing::Broken) user_->on_room();
  }

  void arm_timer() {
    if (closed()) return;
    const std::optional<Instant> next = finishing() ? drain_until_ : wake_at_;
    if (next == armed_for_) return;
    armed_for_ = next;
    if (!next) {
      timer_.cancel();
      return;
    }
    timer_.expires_at(*next);
    timer_.async_wait([self = shared_from_this()](const std::error_code& error) {
      // Cancelled, or overtaken by a wait that was armed since.
      if (error || self->closed() || !self->armed_for_ || self->now() < *self->armed_for_) return;
      self->armed_for_.reset();
      self->on_timer();
      self->go_on();
    });
  }

  void on_timer() {
    if (finishing()) {
      end({});
    } else {
      wake_at_.reset();
      user_->on_time();
    }
  }

  void lose(const std::error_code& error) {
    end({finishing() ? Ending::Why::Finished : Ending::Why::Lost, error.message()});
  }

  void end(const Ending& ending) {
    LinkUser* const user = user_;
    close();
    if (user != nullptr) user->on_closed(ending);
  }

  tcp::socket socket_;
  LinkUser* user_ = nullptr;  ///< null: not started, or closed
  std::string output_;        ///< waits to be sent
  std::size_t sent_ = 0;      ///< of it
  State state_ = State::Open;
  Outgoing outgoing_ = Outgoing::Free;
  Incoming incoming_ = Incoming::Idle;
  bool reading_wanted_ = true;
  std::optional<Instant> wake_at_;
  std::optional<Instant> armed_for_;
  std::optional<Instant> stuck_since_;
  std::optional<Instant> drain_until_;
  std::uint64_t wire_bytes_ = 0;
  std::size_t dropped_bytes_ = 0;
  asio::steady_timer timer_;
  const Limits limits_;
  std::array<char, kReadBytes> input_{};
};

}  // namespace

std::shared_ptr<Link> tcp_link(tcp::socket socket, const Limits& limits, int held_back_max) {
  return std::make_shared<TcpLink>(std::move(socket), limits, held_back_max);
}

}  // namespace aucast::link
