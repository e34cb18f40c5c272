#include "server/serve/transmitter.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>

#include "common/link/tcp_link.h"
#include "common/link/tls_link.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/link_limits.h"
#include "server/live/live_beat.h"
#include "server/live/live_source.h"
#include "server/serve/address_counts.h"
#include "server/serve/connection.h"
#include "server/serve/credentials.h"
#include "server/serve/listener.h"
#include "server/status/http_server.h"
#include "server/status/service_manager.h"
#include "server/status/status.h"
#include "server/streams/catalogue.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

/// Of a live stream, what the system may hold back unsent for one client: some time's worth, but
/// not so little that every packet has to wait for the one before.
constexpr std::size_t kUnsentBytesLeast = 512;
constexpr std::size_t kUnsentBytesMost = 65536;
constexpr std::size_t kUnsentBytesOfSources = 2048;  ///< what they will send is not known

constexpr const char* kPlainText = "text/plain; charset=utf-8";

/// How old an answer about the status may be.
constexpr Milliseconds kStatusAge{250};

/// How often the service manager hears of it.
constexpr std::chrono::seconds kStatusEvery{10};

const char* name_of_signal(int number) {
  return number == SIGINT ? "SIGINT" : "SIGTERM";
}

int unsent_bytes_for(const protocol::ServerCatalogue& catalogue) {
  const std::size_t bytes = bytes_in(catalogue, protocol::kLiveWindowTime / 2);
  const bool unknown = std::any_of(catalogue.streams.begin(), catalogue.streams.end(),
                                   [](const auto& stream) { return !stream.recorded; });
  const std::size_t least = unknown ? kUnsentBytesOfSources : kUnsentBytesLeast;
  return static_cast<int>(std::clamp(bytes, least, kUnsentBytesMost));
}

/// The streams as they were read at one time. SIGHUP brings another one; who is connected keeps the
/// one it came to, which lives as long as any of its clients.
struct Programme {
  explicit Programme(protocol::ServerCatalogue streams)
      : unsent_bytes_max(unsent_bytes_for(streams)), catalogue(std::move(streams)) {}

  int unsent_bytes_max = 0;  ///< of a live stream
  protocol::ServerCatalogue catalogue;
};

/// The listener, the clients and the signals of one run.
class Transmitter {
 public:
  Transmitter(const TransmitterOptions& options, protocol::ServerCatalogue catalogue, Stats& stats,
              Reloader::Load load)
      : options_(options),
        stats_(stats),
        end_signals_(io_, SIGINT, SIGTERM),
        other_signals_(io_, SIGHUP, SIGUSR1),
        stop_timer_(io_),
        tick_timer_(io_),
        listener_(io_),
        beat_(io_, [this] { on_moment(); }),
        programme_(std::make_shared<Programme>(std::move(catalogue))),
        reloader_(io_, std::move(load), [this](Result<protocol::ServerCatalogue> loaded) {
          on_reloaded(std::move(loaded));
        }) {}

  Result<Ending> run(const OnReady& on_ready) {
    if (auto loaded = load_credentials_now(); !loaded) return loaded.error();
    if (auto opened = open_listeners(); !opened) return opened.error();
    if (auto begun = begin_sources(); !begun) return begun.error();
    const std::string address = endpoint_text(listener_.endpoint());
    if (auto ready = on_ready(address); !ready) return ready.error();
    if (listener_.endpoint().address().is_loopback()) {
      spdlog::info("only programs on this host can connect; --bind 0.0.0.0 lets others in");
    }
    if (!programme_->catalogue.token.empty() && !tls_ &&
        !listener_.endpoint().address().is_loopback()) {
      spdlog::warn("without --tls-cert everybody on the way can read the token");
    }
    begin_ = std::chrono::steady_clock::now();
    await_end_signal();
    await_other_signal();
    make_live(programme_->catalogue);
    listener_.start([this](tcp::socket socket, const tcp::endpoint& peer) {
      welcome(std::move(socket), peer);
    });
    if (http_) http_->start();
    manager_.ready(summary());
    tick();
    io_.run();
    client_log_.say_left_out();
    return ending();
  }

 private:
  Result<void> open_listeners() {
    const auto passed = passed_socket();
    if (!passed) return passed.error();
    if (auto opened = *passed ? listener_.open_passed(**passed)
                              : listener_.open(options_.bind, options_.port);
        !opened) {
      return opened;
    }
    if (*passed) spdlog::info("the service manager passed the socket; --bind and --port are idle");
    if (!options_.http) return {};
    http_.emplace(io_, [this](const std::string& path) { return answer(path); });
    auto opened = http_->open(options_.http->address, options_.http->port);
    if (!opened) return opened;
    spdlog::info("status at http://{}/", endpoint_text(http_->endpoint()));
    if (!http_->endpoint().address().is_loopback()) {
      spdlog::warn("--http tells everybody who reaches that address how the transmitter is");
    }
    return {};
  }

  /// What --http answers.
  HttpReply answer(const std::string& path) {
    if (path == "/healthz")
      return {stopping_ ? 503 : 200, kPlainText, stopping_ ? "stopping\n" : "ok\n"};
    if (path == "/metrics")
      return {200, "text/plain; version=0.0.4", metrics_text(recent_status())};
    if (path == "/status.json") return {200, "application/json", status_json(recent_status())};
    if (path == "/") return {200, kPlainText, "/healthz\n/metrics\n/status.json\n"};
    return {404, kPlainText, "there are /healthz, /metrics and /status.json\n"};
  }

  /// However often it is asked for, the clients are counted a few times a second at most.
  const Status& recent_status() {
    const Instant now = std::chrono::steady_clock::now();
    if (!recent_status_ || now - recent_status_at_ >= kStatusAge) {
      recent_status_ = status();
      recent_status_at_ = now;
    }
    return *recent_status_;
  }

  /// One line for the service manager.
  [[nodiscard]] std::string summary() const {
    return counted(connections_.size(), "client") + ", " +
           counted(programme_->catalogue.streams.size(), "stream");
  }

  /// Tells the service manager that the loop goes round.
  void tick() {
    if (!manager_.present()) return;
    if (manager_.watchdog()) manager_.alive();
    manager_.status(summary());
    const Duration pause =
        std::min<Duration>(kStatusEvery, manager_.watchdog().value_or(kStatusEvery) / 2);
    tick_timer_.expires_after(pause);
    tick_timer_.async_wait([this](const std::error_code& error) {
      if (!error) tick();
    });
  }

  Result<void> load_credentials_now() {
    auto loaded = load_credentials(options_.credentials);
    if (!loaded) return loaded.error();
    tls_ = std::move(loaded->tls);
    programme_->catalogue.token = std::move(loaded->token);
    return {};
  }

  /// Certificates and token now, the sources as soon as they are read. Who is connected stays; what
  /// cannot be read changes nothing.
  void reload() {
    spdlog::info("SIGHUP: reading certificates, token and sources again");
    manager_.reloading();
    if (const auto loaded = load_credentials_now(); !loaded) {
      ++reload_failures_;
      spdlog::error("{}; the certificates and token in use stay", loaded.error().message);
    } else {
      spdlog::info("certificates and token were read again");
    }
    condition_sources_anew();
    reloader_.start();
  }

  /// The profile may have changed.
  void condition_sources_anew() {
    if (options_.source.signal.profile.empty() || live_sources_.empty()) return;
    const auto conditioning = conditioning_of(options_.source.signal);
    if (!conditioning) {
      spdlog::error("{}; the profile in use stays", conditioning.error().message);
      return;
    }
    for (const auto& source : live_sources_) source->condition(*conditioning);
    spdlog::info("the profile was read again");
  }

  /// Those that are still being written; they stay the same when others are read again.
  Result<void> begin_sources() {
    const auto conditioning = conditioning_of(options_.source.signal);
    if (!conditioning) return conditioning.error();
    for (const std::filesystem::path& path : options_.sources) {
      if (!is_live(path, options_.live_source.follow)) continue;
      const sources::LiveOptions reader{options_.source.recording, options_.source.rate,
                                        *conditioning, options_.keyframe_ms};
      auto source = std::make_unique<LiveSource>(
          io_,
          LiveSourceOptions{path, options_.live_source.follow, reader, options_.classic_min,
                            options_.live_source.timeout, options_.record, live_sources_.empty(),
                            options_.max_kbits,
                            [this](const auto& neutral) { on_neutral(neutral); }},
          LiveSource::Events{[this] { on_moment_of_source(); }, [this] { on_face(); }});
      if (auto begun = source->start(); !begun) return begun;
      live_sources_.push_back(std::move(source));
    }
    return {};
  }

  void on_neutral(const sources::MeasuredNeutral& neutral) {
    const SignalOptions& signal = options_.source.signal;
    if (signal.save_profile.empty()) return;
    if (const auto saved = save_profile(signal, neutral); !saved) {
      spdlog::error("{}", saved.error().message);
    } else {
      spdlog::info("the profile was written to {}", signal.save_profile.string());
    }
  }

  /// Gives each stream that is to be live its channel: of a source its feed, of a recording, with
  /// --live, one that plays it. A source's faces have streams too, but for names that are taken.
  void make_live(protocol::ServerCatalogue& catalogue) {
    for (protocol::ServedStream& stream : catalogue.streams) {
      if (stream.recorded && options_.live) {
        stream.live =
            beat_.play(stream.name, std::exchange(stream.recorded, nullptr), options_.loop);
      }
    }
    for (protocol::ServedStream& of_source : streams_of_sources()) {
      const auto same =
          std::find_if(catalogue.streams.begin(), catalogue.streams.end(),
                       [&of_source](const auto& stream) { return stream.name == of_source.name; });
      if (same == catalogue.streams.end()) {
        catalogue.streams.push_back(std::move(of_source));
      } else if (!same->recorded && !same->live) {
        same->live = std::move(of_source.live);
      }
    }
    std::erase_if(catalogue.streams, [](const protocol::ServedStream& stream) {
      const bool nothing = !stream.recorded && !stream.live;
      if (nothing) {
        spdlog::error("{}: it is written live now and was not at the start; restart to serve it",
                      stream.name);
      }
      return nothing;
    });
  }

  [[nodiscard]] std::vector<protocol::ServedStream> streams_of_sources() const {
    std::vector<protocol::ServedStream> all;
    for (const auto& source : live_sources_) {
      for (protocol::ServedStream& stream : source->streams()) all.push_back(std::move(stream));
    }
    return all;
  }

  /// A live source sees a face that has no stream yet.
  void on_face() {
    if (!stopping_) make_live(programme_->catalogue);
  }

  void on_moment_of_source() {
    on_moment();
    // Not now: it is a source that calls.
    if (all_over()) {
      asio::post(io_, [this] {
        if (!stopping_) stop("all sources have ended");
      });
    }
  }

  /// Nothing is served any more and nothing can come. Asked at every keyframe: while a source
  /// lasts, no list of streams is made.
  [[nodiscard]] bool all_over() const {
    if (!std::all_of(live_sources_.begin(), live_sources_.end(),
                     [](const auto& source) { return source->over(); })) {
      return false;
    }
    const auto of_sources = streams_of_sources();
    const auto& served = programme_->catalogue.streams;
    return std::all_of(served.begin(), served.end(), [&of_sources](const auto& stream) {
      return std::any_of(of_sources.begin(), of_sources.end(),
                         [&stream](const auto& other) { return other.live == stream.live; });
    });
  }

  /// What went wrong without stopping anything.
  [[nodiscard]] Ending ending() {
    Ending ending;
    ending.reloading = reloader_.running();
    for (const auto& source : live_sources_) {
      if (auto recorded = source->finish_record(); !recorded) ending.error = recorded.error();
      if (source->over() && source->nothing_came()) {
        ending.error = Error{ErrorKind::BadData, source->streams().front().name +
                                                     ": the source ended before a keyframe came"};
      }
    }
    return ending;
  }

  void on_moment() {
    if (audience_.empty()) audience_ = everybody();
    telling_ = true;
    for (const auto& connection : audience_) connection->on_moment();
    telling_ = false;
    if (std::exchange(audience_changed_, false)) audience_.clear();
  }

  /// Somebody came or left.
  void forget_audience() {
    audience_changed_ = telling_;
    if (!telling_) audience_.clear();
  }

  void welcome(tcp::socket socket, const tcp::endpoint& peer) {
    serve_before_newcomers();
    const protocol::Admission admission = admission_of(peer);
    const bool refused = admission != protocol::Admission::Welcome;
    if (refused && refused_.size() >= protocol::kRefusalsMax) {
      ++unheard_;
      spdlog::debug("a client too many was not even heard: {}", endpoint_text(peer));
      return;  // the socket closes
    }
    const std::uint64_t number = ++last_number_;
    auto connection = std::make_shared<Connection>(
        link_of(std::move(socket)),
        std::shared_ptr<const protocol::ServerCatalogue>(programme_, &programme_->catalogue),
        Connection::Settings{number, endpoint_text(peer), &client_log_, options_.client_timeout,
                             admission, options_.batch},
        [this](const ClientRecord& record) { farewell(record); });
    if (refused) {
      refused_.insert(number);
    } else if (options_.max_clients_per_address != 0) {
      of_address_.add(number, peer.address());
    }
    connections_.emplace(number, connection);
    forget_audience();
    connection->start();
  }

  [[nodiscard]] std::shared_ptr<link::Link> link_of(tcp::socket socket) const {
    const int held_back_max = any_live() ? programme_->unsent_bytes_max : 0;
    auto link = link::tcp_link(std::move(socket), protocol::kLinkLimits, held_back_max);
    if (!tls_) return link;
    return link::tls_link(std::move(link), tls::Channel(*tls_), protocol::kLinkLimits,
                          protocol::encode(protocol::ErrorReply{
                              400, "this server speaks TLS only (face-player --tls)"}));
  }

  /// However many knock at once, those who watch are not kept waiting for them.
  void serve_before_newcomers() { beat_.catch_up(); }

  [[nodiscard]] bool any_live() const { return options_.live || !live_sources_.empty(); }

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
    forget_audience();
    refused_.erase(record.number);
    of_address_.remove(record.number);
    if (stopping_ && connections_.empty()) end();
  }

  void await_end_signal() {
    end_signals_.async_wait([this](const std::error_code& error, int number) {
      if (!error) on_end_signal(number);
    });
  }

  void await_other_signal() {
    other_signals_.async_wait([this](const std::error_code& error, int number) {
      if (error) return;
      if (number == SIGHUP) {
        reload();
      } else {
        for (const std::string& line : status_lines(status())) spdlog::info("{}", line);
      }
      await_other_signal();
    });
  }

  void on_reloaded(Result<protocol::ServerCatalogue> loaded) {
    if (stopping_) return;
    take_over(std::move(loaded));
    manager_.ready(summary());
  }

  void take_over(Result<protocol::ServerCatalogue> loaded) {
    if (!loaded) {
      ++reload_failures_;
      std::istringstream lines(loaded.error().message);
      for (std::string line; std::getline(lines, line);) spdlog::error("{}", line);
      spdlog::error("the sources were not taken over; what was served before is served on");
      return;
    }
    ++reloads_;
    auto programme = std::make_shared<Programme>(std::move(*loaded));
    make_live(programme->catalogue);
    if (programme->catalogue.streams.empty()) return;
    share_recorded(programme->catalogue);
    if (same_streams(programme->catalogue, programme_->catalogue)) {
      spdlog::info("the sources hold what they held");
      return;
    }
    programme->catalogue.token = programme_->catalogue.token;
    programme_ = std::move(programme);
    spdlog::info("serving {} now; for the {} here nothing changes",
                 counted(programme_->catalogue.streams.size(), "stream"),
                 counted(connections_.size(), "client"));
  }

  /// What a stream held before is held once.
  void share_recorded(protocol::ServerCatalogue& catalogue) const {
    for (protocol::ServedStream& stream : catalogue.streams) {
      for (const protocol::ServedStream& before : programme_->catalogue.streams) {
        const bool same = stream.recorded && before.recorded && stream.name == before.name &&
                          *stream.recorded == *before.recorded;
        if (same) stream.recorded = before.recorded;
      }
    }
  }

  static bool same_streams(const protocol::ServerCatalogue& a, const protocol::ServerCatalogue& b) {
    return std::equal(a.streams.begin(), a.streams.end(), b.streams.begin(), b.streams.end(),
                      [](const auto& one, const auto& other) {
                        return one.name == other.name && one.recorded == other.recorded &&
                               one.live == other.live;
                      });
  }

  void on_end_signal(int number) {
    const char* name = name_of_signal(number);
    if (stopping_) {
      spdlog::info("{} again: ending at once", name);
      abort_all();
      return;
    }
    stop(name);
    if (!connections_.empty()) await_end_signal();
  }

  void stop(const char* why) {
    stopping_ = true;
    spdlog::info("{}: ending the stream of {}", why, counted(connections_.size(), "client"));
    manager_.stopping();
    listener_.stop();
    for (const auto& source : live_sources_) source->stop();
    beat_.stop();
    for (const auto& connection : everybody()) connection->stop();
    if (connections_.empty()) {
      end();
      return;
    }
    stop_timer_.expires_after(kStopTimeMax);
    stop_timer_.async_wait([this](const std::error_code& error) {
      if (!error) abort_all();
    });
  }

  void abort_all() {
    for (const auto& connection : everybody()) connection->abort();
  }

  /// io_.run() returns, whatever is still waited for. To cancel all of it would not do: what has
  /// come already, such as a SIGUSR1 together with the last signal, would wait for the next.
  void end() { io_.stop(); }

  [[nodiscard]] Status status() const {
    const Instant now = std::chrono::steady_clock::now();
    Status status;
    status.up_seconds = seconds(now - begin_);
    status.live = any_live();
    status.stopping = stopping_;
    for (const auto& stream : programme_->catalogue.streams) status.streams.push_back(stream.name);
    status.clients = connections_.size();
    status.connects = last_number_;
    status.connects_unheard = unheard_;
    status.accept_failures = listener_.failures();
    status.disconnects = stats_.end_reasons();
    status.sent = stats_.totals();
    for (const auto& [number, connection] : connections_) {
      status.sent.add(connection->so_far());
      if (connection->paused()) ++status.clients_paused;
      if (connection->unsent_since()) {
        ++status.clients_behind;
        status.queue_seconds =
            std::max(status.queue_seconds, seconds(now - *connection->unsent_since()));
      }
      status.queue_bytes += connection->output_bytes();
    }
    status.lag_seconds = seconds(beat_.lag());
    status.reloads = reloads_;
    status.reload_failures = reload_failures_;
    return status;
  }

  /// A copy: a connection leaves the map while it is told to go.
  [[nodiscard]] std::vector<std::shared_ptr<Connection>> everybody() const {
    std::vector<std::shared_ptr<Connection>> all;
    for (const auto& [number, connection] : connections_) all.push_back(connection);
    return all;
  }

  const TransmitterOptions& options_;
  Stats& stats_;
  ClientLog client_log_;
  asio::io_context io_{1};
  asio::signal_set end_signals_;
  asio::signal_set other_signals_;
  asio::steady_timer stop_timer_;
  asio::steady_timer tick_timer_;
  ServiceManager manager_;
  Listener listener_;
  std::vector<std::unique_ptr<LiveSource>> live_sources_;
  LiveBeat beat_;
  std::shared_ptr<Programme> programme_;
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;
  std::vector<std::shared_ptr<Connection>> audience_;  ///< the same, or empty: not known
  bool telling_ = false;                               ///< the audience of a moment
  bool audience_changed_ = false;                      ///< meanwhile
  Reloader reloader_;
  std::optional<HttpServer> http_;
  std::optional<Status> recent_status_;
  Instant recent_status_at_{};
  Instant begin_{};
  std::set<std::uint64_t> refused_;  ///< those that are heard only to be told so
  AddressCounts of_address_;         ///< of the others
  std::optional<tls::Context> tls_;
  std::uint64_t last_number_ = 0;
  std::uint64_t unheard_ = 0;
  std::uint64_t reloads_ = 0;
  std::uint64_t reload_failures_ = 0;
  bool stopping_ = false;
};

}  // namespace

Result<Ending> serve(const TransmitterOptions& options, protocol::ServerCatalogue catalogue,
                     Stats& stats, const OnReady& on_ready, Reloader::Load load) {
  std::signal(SIGPIPE, SIG_IGN);
  raise_descriptor_limit();
  auto transmitter =
      std::make_unique<Transmitter>(options, std::move(catalogue), stats, std::move(load));
  auto ending = transmitter->run(on_ready);
  // A disk may take long, and whoever sent SIGTERM does not wait for it.
  if (ending && ending->reloading) static_cast<void>(transmitter.release());
  return ending;
}

}  // namespace aucast::server
