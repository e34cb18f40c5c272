#include "server/engine/nats_bus.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/steady_timer.hpp>

#include "common/link/host.h"
#include "common/link/loop_gate.h"
#include "common/log.h"
#include "common/text.h"
#include "common/thread.h"
#include "common/time.h"
#include "server/engine/nats_loader.h"
#include "server/engine/recurring_complaint.h"

namespace aucast::server {
namespace {

constexpr std::size_t kSaidMax = 200;  ///< of a text of the library, in the log
/// How often an error of the library is logged: a broken server brings one for each message.
constexpr std::chrono::seconds kSayEvery{10};

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

void warn_of_full() {
  spdlog::warn(
      "NATS brings more than this computer works on: what does not fit into {} MiB is left out, "
      "and counted in the status (messages_left_out)",
      link::LoopGate::kBytesMax >> 20U);
}

class NatsBus final : public Bus {
 public:
  NatsBus(asio::io_context& io, const NatsModule& module, NatsServers servers, Events events,
          std::chrono::milliseconds refused_pause)
      : module_(&module),
        servers_(std::move(servers)),
        refused_pause_(refused_pause),
        events_(std::move(events)),
        gate_(std::make_shared<link::LoopGate>(io, [] { warn_of_full(); })),
        timer_(io) {}
  ~NatsBus() override;

  [[nodiscard]] Result<void> open();

  void subscribe(const std::string& subject) override;
  void send(const Message& message) override;
  [[nodiscard]] std::string own_subject() const override { return own_subject_; }
  [[nodiscard]] std::uint64_t left_out() const override { return gate_->left_out(); }

 private:
  class Poster;

  using Made = Result<std::unique_ptr<NatsConnection>>;

  [[nodiscard]] std::shared_ptr<NatsListener> new_listener();
  void use(std::unique_ptr<NatsConnection> connection);
  void add_subscription(const std::string& subject);
  void on_connected(const std::string& server);
  void on_disconnected();
  void on_error(const std::string& text);
  void ask_again_later(const std::string& why);
  void connect_anew();

  const NatsModule* module_;
  NatsServers servers_;
  const std::chrono::milliseconds refused_pause_;
  Events events_;
  std::shared_ptr<link::LoopGate> gate_;
  asio::steady_timer timer_;
  int connections_ = 0;                         ///< made so far; the last is the present one
  std::unique_ptr<NatsConnection> connection_;  ///< null: one was closed, and the next is not open
  std::string connected_early_;  ///< the server that was reported before connection_ was set
  bool owner_knows_ = false;     ///< that there is a connection
  RecurringComplaint errors_{kSayEvery};  ///< of the library
  std::vector<std::string> subjects_;
  std::string own_subject_;
};

/// Posts what the library tells about a connection to the loop, and does nothing else. Connections
/// are numbered, since the end of one is told by a thread of the library, perhaps when the next is
/// there already; of an earlier one only messages and errors count.
class NatsBus::Poster final : public NatsListener {
 public:
  /// `bus` lives until the gate is closed.
  Poster(std::shared_ptr<link::LoopGate> gate, NatsBus& bus, int connection)
      : gate_(std::move(gate)), bus_(bus), connection_(connection) {}

  void on_connected(const std::string& server) override {
    post([server](NatsBus& bus) { bus.on_connected(server); });
  }
  void on_disconnected() override {
    post([](NatsBus& bus) { bus.on_disconnected(); });
  }
  void on_given_up(const std::string& why) override {
    post([why](NatsBus& bus) { bus.ask_again_later(why); });
  }
  void on_message(Bus::Message message) override {
    const std::size_t bytes =
        message.subject.size() + message.reply_to.size() + message.bytes.size();
    gate_->post_if_room(
        [&bus = bus_, message = std::move(message)] { bus.events_.on_message(message); }, bytes);
  }
  void on_error(const std::string& text) override {
    gate_->post_if_room([&bus = bus_, text] { bus.on_error(text); }, text.size());
  }

 private:
  template <typename Act>
  void post(Act act) {
    gate_->post([&bus = bus_, connection = connection_, act = std::move(act)] {
      if (connection == bus.connections_) act(bus);
    });
  }

  std::shared_ptr<link::LoopGate> gate_;
  NatsBus& bus_;
  int connection_;
};

NatsBus::~NatsBus() {
  gate_->close();
  timer_.cancel();
}

std::shared_ptr<NatsListener> NatsBus::new_listener() {
  return std::make_shared<Poster>(gate_, *this, ++connections_);
}

/// Nothing can be sent yet over a connection that has not been passed to us.
void NatsBus::on_connected(const std::string& server) {
  if (connection_) {
    owner_knows_ = true;
    events_.on_connected(server);
  } else {
    connected_early_ = server;
  }
}

void NatsBus::on_disconnected() {
  connected_early_.clear();
  if (std::exchange(owner_knows_, false)) events_.on_disconnected();
}

void NatsBus::on_error(const std::string& text) {
  const auto errors = errors_.happened(std::chrono::steady_clock::now());
  if (!errors) return;
  const std::string more = *errors > 1 ? " (" + std::to_string(*errors) + " errors so far)" : "";
  spdlog::warn("NATS says: {}{}", escaped(text, kSaidMax), more);
}

/// The library gives up when it is refused twice in the same way. We try again, since the servers'
/// permissions may change.
void NatsBus::ask_again_later(const std::string& why) {
  spdlog::warn("NATS refuses us: {}; it is asked again in {} s", escaped(why, kSaidMax),
               seconds(refused_pause_));
  timer_.expires_after(refused_pause_);
  // A wait that is over already cannot be cancelled any more.
  timer_.async_wait([this, gate = gate_](const std::error_code& error) {
    if (!error && gate->is_open()) connect_anew();
  });
}

void NatsBus::connect_anew() {
  // When a subscription was refused it is still connected, and its end waits for the server. What
  // the library tells of that end comes under the old number.
  on_disconnected();
  const auto refused = std::make_shared<std::unique_ptr<NatsConnection>>(std::move(connection_));
  const auto connect = [this, refused, gate = gate_, module = module_, servers = servers_,
                        listener = new_listener()] {
    refused->reset();
    auto made = std::make_shared<Made>(module->connect(servers, listener));
    gate->post([this, made] {
      if (*made) {
        use(std::move(**made));
      } else {
        ask_again_later(made->error().message);
      }
    });
  };
  if (auto started = start_unattended(connect); !started) {
    connection_ = std::move(*refused);
    --connections_;  // it is the present one again
    ask_again_later(started.error().message);
  }
}

Result<void> NatsBus::open() {
  auto subject = module_->new_subject();
  if (!subject) {
    return Error{ErrorKind::Failed,
                 "NATS gives no subject of our own: " + escaped(subject.error().message, kSaidMax)};
  }
  own_subject_ = *std::move(subject);
  // Network: it was refused, and why. Where nobody answers it goes on by itself.
  auto made = module_->connect(servers_, new_listener());
  if (made) {
    use(*std::move(made));
  } else if (made.error().kind == ErrorKind::Network) {
    ask_again_later(made.error().message);
  } else {
    return Error{made.error().kind,
                 "NATS does not take these options: " + escaped(made.error().message, kSaidMax)};
  }
  return {};
}

void NatsBus::use(std::unique_ptr<NatsConnection> connection) {
  connection_ = std::move(connection);
  if (!connection_->is_connected()) {
    spdlog::warn("no server of NATS answers yet; they are tried on");
  }
  for (const std::string& subject : subjects_) add_subscription(subject);
  const std::string server = std::exchange(connected_early_, {});
  if (!server.empty()) on_connected(server);
}

void NatsBus::subscribe(const std::string& subject) {
  subjects_.push_back(subject);
  if (connection_) add_subscription(subject);
}

void NatsBus::add_subscription(const std::string& subject) {
  // Who hears nothing is as good as refused.
  if (auto done = connection_->subscribe(subject); !done) {
    ask_again_later("no subscription to " + subject + ": " + done.error().message);
  }
}

void NatsBus::send(const Message& message) {
  if (!connection_) return;
  if (auto done = connection_->send(message); !done) {
    spdlog::debug("{}: not published: {}", message.subject,
                  escaped(done.error().message, kSaidMax));
  }
}

}  // namespace

Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io, const NatsOptions& options,
                                           Bus::Events events) {
  const auto module = load_nats_module(nats_module_folders());
  if (!module) return module.error();
  return open_nats_bus(io, **module, servers_of(options), std::move(events));
}

Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io, const NatsModule& module,
                                           NatsServers servers, Bus::Events events,
                                           std::chrono::milliseconds refused_pause) {
  auto bus =
      std::make_unique<NatsBus>(io, module, std::move(servers), std::move(events), refused_pause);
  if (auto opened = bus->open(); !opened) return opened.error();
  return std::unique_ptr<Bus>(std::move(bus));
}

}  // namespace aucast::server
