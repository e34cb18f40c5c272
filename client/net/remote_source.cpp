#include "client/net/remote_source.h"

#include <chrono>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "client/net/dialling.h"
#include "client/net/server_connection.h"
#include "common/link/host.h"
#include "common/link/loop_gate.h"
#include "common/text.h"
#include "common/thread.h"

namespace aucast::net {
namespace {

/// HOST:PORT of all servers, for messages.
std::string peer_names(const RemoteOptions& options) {
  std::string names = link::host_and_port(options.host, options.port);
  for (const Endpoint& other : options.others) {
    names += " or " + link::host_and_port(other.host, other.port);
  }
  return names;
}

AuReaderOptions reader_options(const RemoteOptions& options) {
  AuReaderOptions reader;
  static_cast<StreamRequest&>(reader) = options;
  reader.peer = peer_names(options);
  reader.silence_max = options.connect_timeout;
  reader.token = options.security.token;
  reader.hosts = 1 + options.others.size();
  return reader;
}

}  // namespace

/// The connection, what it needs of Asio, and the thread that runs it. All members belong to that
/// thread but the reader, which is shared; post_*() may be called from others.
class RemoteSource::Network {
 public:
  Network(SharedReader& reader, RemoteOptions options)
      : reader_(reader), options_(std::move(options)) {
    auto started = start_thread([this] { run(); });
    if (started) {
      thread_ = std::move(*started);
    } else {
      connection_.fail(started.error().message, true);
    }
  }

  /// The player has asked the reader for something, after which it may have something to send.
  void post_speak() {
    gate_->post([this] { connection_.speak(std::chrono::steady_clock::now()); });
  }
  void post_leave() {
    gate_->post([this] { connection_.leave(); });
  }

 private:
  void run() {
    // Asio throws when the system has no descriptor left for it.
    try {
      dial();
      io_.run();
    } catch (const std::system_error& failure) {
      connection_.fail(shortage_text(failure), true);
    }
  }

  void dial() {
    dialler_.dial(dial_options(options_, attempt_),
                  [this](link::Dialled dialled) { on_dialled(std::move(dialled)); });
  }

  void on_dialled(link::Dialled dialled) {
    if (auto* const link = std::get_if<std::shared_ptr<link::Link>>(&dialled)) {
      connection_.begin(std::move(*link));
    } else {
      const auto& failure = std::get<link::DialFailure>(dialled);
      connection_.fail(failure.reason, failure.final);
    }
  }

  void dial_after(Milliseconds wait) {
    // At once is the same server again, asked in another way.
    if (wait > Milliseconds::zero()) ++attempt_;
    wait_.expires_after(wait);
    wait_.async_wait([this](const std::error_code& error) {
      // end() may come when this handler is queued already, and then no cancelling reaches it.
      if (!error && work_.owns_work()) dial();
    });
  }

  void end() {
    dialler_.cancel();
    wait_.cancel();
    work_.reset();
  }

  void tell_player() {
    reader_.wake();
    if (options_.wakeup) options_.wakeup();
  }

  SharedReader& reader_;
  const RemoteOptions options_;
  asio::io_context io_{1};
  const std::shared_ptr<link::LoopGate> gate_ = std::make_shared<link::LoopGate>(io_);
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  link::Dialler dialler_{io_};
  std::size_t attempt_ = 0;       ///< as dial_options() counts them
  asio::steady_timer wait_{io_};  ///< before the next attempt
  ServerConnection connection_{reader_,
                               peer_names(options_),
                               {[this](Milliseconds wait) { dial_after(wait); }},
                               {[this] { end(); }, [this] { tell_player(); }}};
  std::jthread thread_;  ///< last: it ends before anything it uses is gone
};

RemoteSource::RemoteSource(RemoteOptions options) : ConnectedSource(reader_options(options)) {
  try {
    network_ = std::make_unique<Network>(reader(), std::move(options));
  } catch (const std::system_error& failure) {  // as in run()
    static_cast<void>(reader().with([&failure](AuReader& reader) {
      return reader.refused(playback::EndReason::Refused, shortage_text(failure));
    }));
  }
}

RemoteSource::~RemoteSource() {
  stop();
}

bool RemoteSource::wait_until(Instant until) {
  const auto ready = [](const AuReader& reader) { return reader.ready(); };
  return reader().wait_until(until, ready, ready);
}

void RemoteSource::speak() {
  if (network_) network_->post_speak();
}

void RemoteSource::leave() {
  if (network_) network_->post_leave();
}

}  // namespace aucast::net
