#include "server/engine/nats_bus.h"

#include <chrono>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/steady_timer.hpp>

#include "common/link/host.h"
#include "common/log.h"
#include "common/text.h"
#include "server/engine/loop_gate.h"
#include "server/engine/nats_loader.h"

namespace aucast::server {
namespace {

constexpr int kRefusedSeconds = 4;
constexpr std::size_t kSaidMax = 200;  ///< of what the library says, in the log

NatsServers servers_of(const NatsOptions& options) {
  const EngineSettings& settings = options.settings;
  NatsServers servers;
  for (const protocol::Endpoint& server : options.address.hosts) {
    servers.urls.push_back((options.address.tls ? "tls://" : "nats://") +
                           link::host_and_port(server.host, server.port));
  }
  servers.tls = options.address.tls;
  servers.token = options.token;
  servers.user = options.user;
  servers.password = options.password;
  servers.creds = settings.creds.string();
  servers.nkey = settings.nkey;
  servers.seed = settings.seed.string();
  servers.authorities = settings.tls.authorities.string();
  servers.certificate = settings.tls.certificate.string();
  servers.key = settings.tls.key.string();
  return servers;
}

/// Posts what the library tells to the loop, nothing else.
class Poster final : public NatsListener {
 public:
  explicit Poster(std::shared_ptr<LoopGate> gate) : gate_(std::move(gate)) {}

  void on_connected(const std::string& server) override {
    gate_->post([server](const LibraryEvents& events) { events.owner.on_connected(server); }, 0);
  }
  void on_disconnected() override {
    gate_->post([](const LibraryEvents& events) { events.owner.on_disconnected(); }, 0);
  }
  void on_message(Bus::Message message) override {
    const std::size_t bytes = message.bytes.size();
    gate_->post([message = std::move(message)](
                    const LibraryEvents& events) { events.owner.on_message(message); },
                bytes);
  }
  void on_error(const std::string& text) override {
    gate_->post(
        [text](const LibraryEvents&) { spdlog::warn("NATS says: {}", escaped(text, kSaidMax)); },
        text.size());
  }
  void on_given_up(const std::string& why) override {
    gate_->post([why](const LibraryEvents& events) { events.on_given_up(why); }, 0);
  }

 private:
  std::shared_ptr<LoopGate> gate_;
};

class NatsBus final : public Bus {
 public:
  NatsBus(asio::io_context& io, const NatsModule& module, NatsServers servers, Events events)
      : module_(&module),
        servers_(std::move(servers)),
        gate_(std::make_shared<LoopGate>(
            io, LibraryEvents{std::move(events),
                              [this](const std::string& why) { on_given_up(why); }})),
        listener_(std::make_shared<Poster>(gate_)),
        timer_(io) {}
  ~NatsBus() override;

  [[nodiscard]] Result<void> open();

  void subscribe(const std::string& subject) override;
  void publish(const Message& message) override;
  [[nodiscard]] std::string own_subject() const override { return own_subject_; }

 private:
  [[nodiscard]] Result<void> connect();
  void add_subscription(const std::string& subject);
  void on_given_up(const std::string& why);
  void connect_anew();

  const NatsModule* module_;
  NatsServers servers_;
  std::shared_ptr<LoopGate> gate_;
  std::shared_ptr<Poster> listener_;
  asio::steady_timer timer_;
  std::unique_ptr<NatsConnection> connection_;  ///< null: between one that is closed and the next
  std::vector<std::string> subjects_;
  std::string own_subject_;
};

NatsBus::~NatsBus() {
  gate_->close();
  timer_.cancel();
}

/// The library gives up for ever when it is refused twice in the same way; we do not: who may come
/// in may be changed at the servers.
void NatsBus::on_given_up(const std::string& why) {
  spdlog::warn("NATS refuses us: {}; it is asked again in {} s", escaped(why, kSaidMax),
               kRefusedSeconds);
  timer_.expires_after(std::chrono::seconds(kRefusedSeconds));
  // A wait that is over already cannot be cancelled any more.
  timer_.async_wait([this, gate = gate_](const std::error_code& error) {
    if (!error && gate->is_open()) connect_anew();
  });
}

void NatsBus::connect_anew() {
  connection_.reset();
  if (auto connected = connect(); !connected) {
    on_given_up(connected.error().message);
    return;
  }
  for (const std::string& subject : subjects_) add_subscription(subject);
}

Result<void> NatsBus::open() {
  auto subject = module_->new_subject();
  if (!subject) {
    return Error{ErrorKind::Failed,
                 "NATS gives no subject of our own: " + escaped(subject.error().message, kSaidMax)};
  }
  own_subject_ = *std::move(subject);
  auto connected = connect();
  if (connected) return {};
  if (connected.error().kind == ErrorKind::Network) {
    on_given_up(connected.error().message);
    return {};
  }
  return Error{connected.error().kind,
               "NATS does not take these options: " + escaped(connected.error().message, kSaidMax)};
}

/// Network: it was refused, and why. Where nobody answers it goes on by itself.
Result<void> NatsBus::connect() {
  auto connection = module_->connect(servers_, listener_);
  if (!connection) return connection.error();
  connection_ = *std::move(connection);
  if (!connection_->is_connected()) {
    spdlog::warn("no server of NATS answers yet; they are tried on");
  }
  return {};
}

void NatsBus::subscribe(const std::string& subject) {
  subjects_.push_back(subject);
  if (connection_) add_subscription(subject);
}

void NatsBus::add_subscription(const std::string& subject) {
  // Who hears nothing is as good as refused.
  if (auto done = connection_->subscribe(subject); !done) {
    on_given_up("no subscription to " + subject + ": " + done.error().message);
  }
}

void NatsBus::publish(const Message& message) {
  if (!connection_) return;
  if (auto done = connection_->publish(message); !done) {
    spdlog::debug("{}: not published: {}", message.subject,
                  escaped(done.error().message, kSaidMax));
  }
}

}  // namespace

Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io, const NatsOptions& options,
                                           Bus::Events events) {
  const auto module = load_nats_module(nats_module_folders());
  if (!module) return module.error();
  auto bus = std::make_unique<NatsBus>(io, **module, servers_of(options), std::move(events));
  if (auto opened = bus->open(); !opened) return opened.error();
  return std::unique_ptr<Bus>(std::move(bus));
}

}  // namespace aucast::server
