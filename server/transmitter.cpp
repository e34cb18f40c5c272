#include "server/transmitter.h"

#include <sys/resource.h>

#include <csignal>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>

#include "common/log.h"
#include "server/connection.h"
#include "server/listener.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

/// A descriptor a client: take as many as the system lets us have.
void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == limit.rlim_max) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

/// The listener, the clients and the signals of one run.
class Transmitter {
 public:
  Transmitter(const TransmitterOptions& options, const protocol::ServerCatalogue& catalogue,
              Stats& stats)
      : options_(options),
        catalogue_(catalogue),
        stats_(stats),
        signals_(io_, SIGINT, SIGTERM),
        stop_timer_(io_),
        listener_(io_) {}

  Result<void> run(const OnReady& on_ready) {
    if (auto opened = listener_.open(options_.bind, options_.port); !opened) return opened;
    const std::string address = endpoint_text(listener_.endpoint());
    if (auto ready = on_ready(address); !ready) return ready;
    if (listener_.endpoint().address().is_loopback()) {
      spdlog::info("only programs on this host can connect; --bind 0.0.0.0 lets others in");
    }
    await_signal();
    listener_.start([this](tcp::socket socket, const tcp::endpoint& peer) {
      welcome(std::move(socket), peer);
    });
    io_.run();
    return {};
  }

 private:
  void welcome(tcp::socket socket, const tcp::endpoint& peer) {
    const std::uint64_t number = ++last_number_;
    auto connection = std::make_shared<Connection>(
        std::move(socket), catalogue_,
        Connection::Settings{number, endpoint_text(peer), options_.client_timeout},
        [this](const ClientRecord& record) { farewell(record); });
    connections_.emplace(number, connection);
    connection->start();
  }

  void farewell(const ClientRecord& record) {
    stats_.add(record);
    connections_.erase(record.number);
    if (stopping_ && connections_.empty()) end();
  }

  void await_signal() {
    signals_.async_wait([this](const std::error_code& error, int number) {
      if (!error) on_signal(number);
    });
  }

  void on_signal(int number) {
    const char* name = number == SIGINT ? "SIGINT" : "SIGTERM";
    if (std::exchange(stopping_, true)) {
      spdlog::info("{} again: ending at once", name);
      abort_all();
      return;
    }
    spdlog::info("{}: ending the stream of {} clients", name, connections_.size());
    listener_.stop();
    for (const auto& connection : everybody()) connection->stop();
    if (connections_.empty()) {
      end();
      return;
    }
    await_signal();
    stop_timer_.expires_after(kStopTimeMax);
    stop_timer_.async_wait([this](const std::error_code& error) {
      if (!error) abort_all();
    });
  }

  void abort_all() {
    for (const auto& connection : everybody()) connection->abort();
  }

  /// Nothing is left to wait for, so io_.run() returns.
  void end() {
    std::error_code ignored;
    signals_.cancel(ignored);
    stop_timer_.cancel();
  }

  /// A copy: a connection leaves the map while it is told to go.
  [[nodiscard]] std::vector<std::shared_ptr<Connection>> everybody() const {
    std::vector<std::shared_ptr<Connection>> all;
    for (const auto& [number, connection] : connections_) all.push_back(connection);
    return all;
  }

  const TransmitterOptions& options_;
  const protocol::ServerCatalogue& catalogue_;
  Stats& stats_;
  asio::io_context io_{1};
  asio::signal_set signals_;
  asio::steady_timer stop_timer_;
  Listener listener_;
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;
  std::uint64_t last_number_ = 0;
  bool stopping_ = false;
};

}  // namespace

Result<void> serve(const TransmitterOptions& options, const protocol::ServerCatalogue& catalogue,
                   Stats& stats, const OnReady& on_ready) {
  std::signal(SIGPIPE, SIG_IGN);
  raise_descriptor_limit();
  return Transmitter(options, catalogue, stats).run(on_ready);
}

}  // namespace aucast::server
