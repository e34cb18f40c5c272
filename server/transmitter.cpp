#include "server/transmitter.h"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>

#include "common/log.h"
#include "protocol/limits.h"
#include "server/catalogue.h"
#include "server/connection.h"
#include "server/listener.h"
#include "server/live_beat.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

/// Clients that are told that there is no room for them, at a time; what is more is just closed.
constexpr std::size_t kRefusalsMax = 64;

/// Of a live stream, what the system may hold back unsent for one client: some time's worth, but
/// not so little that every packet has to wait for the one before.
constexpr std::size_t kUnsentBytesLeast = 512;
constexpr std::size_t kUnsentBytesMost = 65536;

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
  Transmitter(const TransmitterOptions& options, protocol::ServerCatalogue catalogue, Stats& stats)
      : options_(options),
        catalogue_(std::move(catalogue)),
        stats_(stats),
        signals_(io_, SIGINT, SIGTERM),
        stop_timer_(io_),
        listener_(io_),
        beat_(io_) {}

  Result<void> run(const OnReady& on_ready) {
    if (auto opened = listener_.open(options_.bind, options_.port); !opened) return opened;
    const std::string address = endpoint_text(listener_.endpoint());
    if (auto ready = on_ready(address); !ready) return ready;
    if (listener_.endpoint().address().is_loopback()) {
      spdlog::info("only programs on this host can connect; --bind 0.0.0.0 lets others in");
    }
    await_signal();
    if (options_.live) begin_live();
    listener_.start([this](tcp::socket socket, const tcp::endpoint& peer) {
      welcome(std::move(socket), peer);
    });
    io_.run();
    return {};
  }

 private:
  void begin_live() {
    const std::size_t bytes = bytes_in(catalogue_, protocol::kLiveWindowTime / 2);
    unsent_bytes_max_ = static_cast<int>(std::clamp(bytes, kUnsentBytesLeast, kUnsentBytesMost));
    beat_.start(catalogue_, [this] { on_moment(); });
  }

  void on_moment() {
    // Whoever is lost on the way leaves the map, the others stay where they are.
    for (auto next = connections_.begin(); next != connections_.end();) {
      const std::shared_ptr<Connection> connection = (next++)->second;
      connection->on_moment();
    }
  }

  void welcome(tcp::socket socket, const tcp::endpoint& peer) {
    const std::size_t clients_max = options_.max_clients;
    const bool full = clients_max != 0 && connections_.size() >= clients_max;
    if (full && connections_.size() >= clients_max + kRefusalsMax) {
      spdlog::debug("a client too many was not even heard: {}", endpoint_text(peer));
      return;  // the socket closes
    }
    const std::uint64_t number = ++last_number_;
    auto connection = std::make_shared<Connection>(
        std::move(socket), catalogue_,
        Connection::Settings{number, endpoint_text(peer), options_.client_timeout,
                             full ? protocol::Admission::Full : protocol::Admission::Welcome,
                             unsent_bytes_max_},
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
    beat_.stop();
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
  protocol::ServerCatalogue catalogue_;
  Stats& stats_;
  asio::io_context io_{1};
  asio::signal_set signals_;
  asio::steady_timer stop_timer_;
  Listener listener_;
  LiveBeat beat_;
  int unsent_bytes_max_ = 0;
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;
  std::uint64_t last_number_ = 0;
  bool stopping_ = false;
};

}  // namespace

Result<void> serve(const TransmitterOptions& options, protocol::ServerCatalogue catalogue,
                   Stats& stats, const OnReady& on_ready) {
  std::signal(SIGPIPE, SIG_IGN);
  raise_descriptor_limit();
  return Transmitter(options, std::move(catalogue), stats).run(on_ready);
}

}  // namespace aucast::server
