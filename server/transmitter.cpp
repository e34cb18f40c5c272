#include "server/transmitter.h"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>

#include "common/log.h"
#include "protocol/limits.h"
#include "server/address_counts.h"
#include "server/catalogue.h"
#include "server/connection.h"
#include "server/credentials.h"
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
        hangup_(io_, SIGHUP),
        stop_timer_(io_),
        listener_(io_),
        beat_(io_) {}

  Result<void> run(const OnReady& on_ready) {
    if (auto loaded = load(); !loaded) return loaded;
    if (auto opened = listener_.open(options_.bind, options_.port); !opened) return opened;
    const std::string address = endpoint_text(listener_.endpoint());
    if (auto ready = on_ready(address); !ready) return ready;
    if (listener_.endpoint().address().is_loopback()) {
      spdlog::info("only programs on this host can connect; --bind 0.0.0.0 lets others in");
    }
    if (!catalogue_.token.empty() && !tls_ && !listener_.endpoint().address().is_loopback()) {
      spdlog::warn("without --tls-cert everybody on the way can read the token");
    }
    await_signal();
    await_hangup();
    if (options_.live) begin_live();
    listener_.start([this](tcp::socket socket, const tcp::endpoint& peer) {
      welcome(std::move(socket), peer);
    });
    io_.run();
    return {};
  }

  /// Reads certificates and token again. Who is connected stays; what cannot be read changes
  /// nothing.
  void reload() {
    if (const auto loaded = load(); !loaded) {
      spdlog::error("{}; the certificates and token in use stay", loaded.error().message);
    } else {
      spdlog::info("certificates and token were read again");
    }
  }

 private:
  Result<void> load() {
    auto loaded = load_credentials(options_.credentials);
    if (!loaded) return loaded.error();
    tls_ = std::move(loaded->tls);
    catalogue_.token = std::move(loaded->token);
    return {};
  }

  void await_hangup() {
    hangup_.async_wait([this](const std::error_code& error, int) {
      if (error) return;
      reload();
      await_hangup();
    });
  }

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
    const protocol::Admission admission = admission_of(peer);
    const bool refused = admission != protocol::Admission::Welcome;
    if (refused && refused_.size() >= kRefusalsMax) {
      spdlog::debug("a client too many was not even heard: {}", endpoint_text(peer));
      return;  // the socket closes
    }
    const std::uint64_t number = ++last_number_;
    auto connection = std::make_shared<Connection>(
        std::move(socket), catalogue_,
        Connection::Settings{number, endpoint_text(peer), options_.client_timeout, admission,
                             unsent_bytes_max_, tls_},
        [this](const ClientRecord& record) { farewell(record); });
    if (refused) {
      refused_.insert(number);
    } else if (options_.max_clients_per_address != 0) {
      of_address_.add(number, peer.address());
    }
    connections_.emplace(number, connection);
    connection->start();
  }

  [[nodiscard]] protocol::Admission admission_of(const tcp::endpoint& peer) const {
    const std::size_t inside = connections_.size() - refused_.size();
    if (options_.max_clients != 0 && inside >= options_.max_clients) {
      return protocol::Admission::Full;
    }
    const std::size_t most = options_.max_clients_per_address;
    if (most != 0 && of_address_.count(peer.address()) >= most) {
      return protocol::Admission::FullAddress;
    }
    return protocol::Admission::Welcome;
  }

  void farewell(const ClientRecord& record) {
    stats_.add(record);
    connections_.erase(record.number);
    refused_.erase(record.number);
    of_address_.remove(record.number);
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
    hangup_.cancel(ignored);
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
  asio::signal_set hangup_;
  asio::steady_timer stop_timer_;
  Listener listener_;
  LiveBeat beat_;
  int unsent_bytes_max_ = 0;
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;
  std::set<std::uint64_t> refused_;  ///< those that are heard only to be told so
  AddressCounts of_address_;         ///< of the others
  std::optional<tls::Context> tls_;
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
