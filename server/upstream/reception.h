#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <asio/io_context.hpp>

#include "common/link/link.h"
#include "common/link/loop_timer.h"
#include "common/time.h"
#include "protocol/server_session.h"
#include "server/status/status.h"
#include "server/upstream/parent.h"
#include "server/upstream/relayed_stream.h"

namespace aucast::server {

/// Receives one stream from another server, over one connection at a time, whichever side made it.
/// Without a connection the clients' faces hold; if the next connection does not come in time, the
/// stream ends for the clients. Reports to log and status.
/// Thread: that of the io_context, which must outlive it.
class Reception {
 public:
  struct Options {
    std::string name;           ///< of the stream; empty: the parent's first
    std::string id;             ///< of this server, by which it notices its own streams
    Milliseconds wait{10'000};  ///< how long clients wait while nobody sends
    int classic_min = 20;
    const char* sender = "parent";  ///< what the log calls the sender
    RelayedStream::TakeName take_name{};
  };
  struct Events {
    std::function<void()> on_moment;  ///< the stream has something new
    std::function<void()> on_first;   ///< a connection has brought its first keyframe
    /// A connection has ended and was dropped. Unless whole(), a new one is needed.
    std::function<void(const Parent::Outcome&)> on_over;
    std::function<void()> on_given_up = [] {};  ///< clients were told that the stream has ended
  };

  Reception(asio::io_context& io, Options options, Events events);
  ~Reception() { stop(); }
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  /// Begins to count how long clients wait.
  void start();
  void stop();
  /// Starts `link`, which is not yet started, asks `peer` for the stream and receives it.
  void begin(std::shared_ptr<link::Link> link, std::string peer, const std::string& token);
  /// The same over a link that is already open, whose peer has offered the stream.
  void take_over(std::shared_ptr<link::Link> link, std::string peer);
  /// Another stream of the same name will come: this one ends for its clients, and later clients
  /// get what the next connection brings. Only while not connected().
  void begin_anew();

  /// Drops the present connection, if any.
  void drop();
  /// Stops, and tells the clients that the stream has ended.
  void end();

  [[nodiscard]] bool connected() const { return parent_ != nullptr; }
  /// Whether clients were told that the stream has ended, and nothing has come since.
  [[nodiscard]] bool given_up() const { return state_ == State::GivenUp; }
  /// Whether a recorded stream is here to its end.
  [[nodiscard]] bool whole() const { return stream_.whole(); }
  [[nodiscard]] std::string name() const;  ///< for the log
  [[nodiscard]] std::shared_ptr<const protocol::UpstreamStream> shared() const {
    return stream_.shared();
  }
  /// The stream in the form in which it is served, under its name.
  [[nodiscard]] protocol::ServedStream served() const;
  [[nodiscard]] UpstreamStatus status() const;

 private:
  enum class State : std::uint8_t {
    Waiting,    ///< for a first keyframe, or for the next parent's
    Receiving,  ///< the parent has sent a keyframe
    GivenUp,    ///< no keyframe came in time, and the clients were told
    Whole,      ///< a recorded stream is here to its end, and that was logged
    Stopped,
  };

  void connect(std::shared_ptr<link::Link> link, std::string peer,
               const Parent::Greeting& greeting);
  void on_moved_on();
  void on_over(const Parent::Outcome& outcome);
  void drop_parent();
  void say_goes_on();
  void await_giving_up();
  void give_up();

  Options options_;
  Events events_;
  RelayedStream stream_;
  link::LoopTimer timer_;           ///< for a keyframe
  std::unique_ptr<Parent> parent_;  ///< null: none is connected
  std::string peer_;
  State state_ = State::Waiting;
  bool ever_received_ = false;  ///< of this stream
  Instant silent_since_{};      ///< while not receiving
  std::uint64_t connects_ = 0;
  std::uint64_t losses_ = 0;
  std::uint64_t keyframes_before_ = 0;  ///< of parents that were left
  std::uint64_t bytes_before_ = 0;
};

}  // namespace aucast::server
