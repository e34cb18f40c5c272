#include "server/engine/nats_bus.h"

#include <nats/nats.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/steady_timer.hpp>

#include "common/link/host.h"
#include "common/log.h"
#include "common/text.h"
#include "server/engine/loop_gate.h"

namespace aucast::server {
namespace {

/// What is held open for a server that does not answer: the loop waits meanwhile, at the start and
/// with each question after a refusal.
constexpr int kConnectMs = 1'000;
constexpr int kReconnectMs = 250;  ///< between two rounds of all servers
constexpr int kReconnectJitterMs = 100;
/// A server that is gone without a word is found after the second unanswered ping.
constexpr int kPingMs = 2'000;
constexpr int kPingsUnanswered = 2;
/// Bytes that the library keeps to send them when it is connected again: none, for they would be
/// old. 0 would be its own choice, 8 MB.
constexpr int kKeptBytes = 1;
constexpr int kFlushMs = 200;  ///< for the last words
constexpr int kRefusedSeconds = 4;

struct OptionsDeleter {
  void operator()(natsOptions* options) const { natsOptions_Destroy(options); }
};
using OptionsPtr = std::unique_ptr<natsOptions, OptionsDeleter>;

/// What the library hands to its callbacks: holds the gate until the last of them.
using Held = std::shared_ptr<LoopGate>;

LoopGate& gate_of(void* held) {
  return **static_cast<Held*>(held);
}

void let_go(void* held) {
  delete static_cast<Held*>(held);
}

std::string server_of(natsConnection* connection) {
  std::array<char, 256> url{};
  if (natsConnection_GetConnectedUrl(connection, url.data(), url.size()) != NATS_OK) return "?";
  return url.data();
}

// Callbacks: on threads of the library. They post, nothing else.

void on_connected(natsConnection* connection, void* held) {
  gate_of(held).post([server = server_of(connection)](
                         const LibraryEvents& events) { events.owner.on_connected(server); },
                     0);
}

void on_disconnected(natsConnection* /*connection*/, void* held) {
  gate_of(held).post([](const LibraryEvents& events) { events.owner.on_disconnected(); }, 0);
}

std::string last_error_of(natsConnection* connection) {
  const char* last = nullptr;
  static_cast<void>(natsConnection_GetLastError(connection, &last));
  return last == nullptr ? "" : last;
}

/// The last of them for this connection: it is destroyed, or was refused twice.
void on_closed(natsConnection* connection, void* held) {
  gate_of(held).post(
      [why = last_error_of(connection)](const LibraryEvents& events) { events.on_given_up(why); },
      0);
  let_go(held);
}

void on_error(natsConnection* connection, natsSubscription* /*subscription*/, natsStatus status,
              void* held) {
  const std::string text =
      std::string(natsStatus_GetText(status)) + ' ' + last_error_of(connection);
  gate_of(held).post(
      [text](const LibraryEvents&) { spdlog::warn("NATS says: {}", escaped(text, 200)); },
      text.size());
}

void on_message(natsConnection* /*connection*/, natsSubscription* /*subscription*/,
                natsMsg* message, void* held) {
  Bus::Message copy;
  copy.subject = natsMsg_GetSubject(message);
  const char* const reply = natsMsg_GetReply(message);
  if (reply != nullptr) copy.reply_to = reply;
  copy.bytes.assign(natsMsg_GetData(message),
                    static_cast<std::size_t>(natsMsg_GetDataLength(message)));
  natsMsg_Destroy(message);
  const std::size_t bytes = copy.bytes.size();
  gate_of(held).post(
      [copy = std::move(copy)](const LibraryEvents& events) { events.owner.on_message(copy); },
      bytes);
}

class NatsBus final : public Bus {
 public:
  NatsBus(asio::io_context& io, NatsOptions options, Events events)
      : options_(std::move(options)),
        gate_(std::make_shared<LoopGate>(
            io, LibraryEvents{std::move(events),
                              [this](const std::string& why) { on_given_up(why); }})),
        timer_(io) {}
  ~NatsBus() override;

  [[nodiscard]] Result<void> open();

  void subscribe(const std::string& subject) override;
  void publish(const Message& message) override;
  [[nodiscard]] std::string own_subject() const override { return own_subject_; }

 private:
  [[nodiscard]] Result<void> connect();
  [[nodiscard]] natsStatus set_up(natsOptions* options) const;
  [[nodiscard]] natsStatus set_up_secrets(natsOptions* options) const;
  [[nodiscard]] static natsStatus set_up_callbacks(natsOptions* options, Held* held);
  void add_subscription(const std::string& subject);
  void on_given_up(const std::string& why);
  void connect_anew();
  void disconnect();

  NatsOptions options_;
  std::shared_ptr<LoopGate> gate_;
  asio::steady_timer timer_;
  natsConnection* connection_ = nullptr;  ///< null: between one that is closed and the next
  std::vector<std::string> subjects_;
  std::vector<natsSubscription*> subscriptions_;
  std::string own_subject_;
};

NatsBus::~NatsBus() {
  gate_->close();
  timer_.cancel();
  disconnect();
}

void NatsBus::disconnect() {
  if (connection_ == nullptr) return;
  if (natsConnection_Status(connection_) == NATS_CONN_STATUS_CONNECTED) {
    static_cast<void>(natsConnection_FlushTimeout(connection_, kFlushMs));
  }
  for (natsSubscription* const subscription : std::exchange(subscriptions_, {})) {
    natsSubscription_Destroy(subscription);
  }
  natsConnection_Destroy(std::exchange(connection_, nullptr));
}

/// The library gives up for ever when it is refused twice in the same way; we do not: who may come
/// in may be changed at the servers.
void NatsBus::on_given_up(const std::string& why) {
  spdlog::warn("NATS refuses us: {}; it is asked again in {} s", escaped(why, 200),
               kRefusedSeconds);
  timer_.expires_after(std::chrono::seconds(kRefusedSeconds));
  // A wait that is over already cannot be cancelled any more.
  timer_.async_wait([this, gate = gate_](const std::error_code& error) {
    if (!error && gate->is_open()) connect_anew();
  });
}

void NatsBus::connect_anew() {
  disconnect();
  if (auto connected = connect(); !connected) {
    on_given_up(connected.error().message);
    return;
  }
  for (const std::string& subject : subjects_) add_subscription(subject);
}

/// What the library says of its last failure, without the place in its sources; else the status.
std::string reason_of(natsStatus status) {
  natsStatus last = status;
  const char* const said = nats_GetLastError(&last);
  std::string_view text = said == nullptr ? "" : said;
  if (text.starts_with('(')) text.remove_prefix(std::min(text.find(": "), text.size()));
  if (text.starts_with(": ")) text.remove_prefix(2);
  return text.empty() ? natsStatus_GetText(status) : escaped(text, 200);
}

/// Nobody was there to refuse us.
bool may_come_yet(natsStatus status) {
  return status == NATS_NO_SERVER || status == NATS_TIMEOUT || status == NATS_IO_ERROR ||
         status == NATS_NOT_YET_CONNECTED;
}

natsStatus NatsBus::set_up(natsOptions* options) const {
  std::vector<std::string> urls;
  for (const protocol::Endpoint& server : options_.address.hosts) {
    urls.push_back((options_.address.tls ? "tls://" : "nats://") +
                   link::host_and_port(server.host, server.port));
  }
  std::vector<const char*> list;
  for (const std::string& url : urls) list.push_back(url.c_str());
  natsStatus status = natsOptions_SetServers(options, list.data(), static_cast<int>(list.size()));
  const auto then = [&status](natsStatus (*set)(natsOptions*, bool), natsOptions* to, bool value) {
    if (status == NATS_OK) status = set(to, value);
  };
  then(natsOptions_SetNoRandomize, options, true);
  if (status == NATS_OK) status = natsOptions_SetName(options, "au-transmitter");
  if (status == NATS_OK) status = natsOptions_SetTimeout(options, kConnectMs);
  if (status == NATS_OK) status = natsOptions_SetMaxReconnect(options, -1);
  if (status == NATS_OK) status = natsOptions_SetReconnectWait(options, kReconnectMs);
  if (status == NATS_OK) {
    status = natsOptions_SetReconnectJitter(options, kReconnectJitterMs, kReconnectJitterMs);
  }
  if (status == NATS_OK) status = natsOptions_SetReconnectBufSize(options, kKeptBytes);
  if (status == NATS_OK) status = natsOptions_SetPingInterval(options, kPingMs);
  if (status == NATS_OK) status = natsOptions_SetMaxPingsOut(options, kPingsUnanswered);
  return status;
}

natsStatus NatsBus::set_up_secrets(natsOptions* options) const {
  const EngineSettings& settings = options_.settings;
  natsStatus status = NATS_OK;
  if (!options_.token.empty()) status = natsOptions_SetToken(options, options_.token.c_str());
  if (status == NATS_OK && !options_.user.empty()) {
    status = natsOptions_SetUserInfo(options, options_.user.c_str(), options_.password.c_str());
  }
  if (status == NATS_OK && !settings.creds.empty()) {
    status = natsOptions_SetUserCredentialsFromFiles(options, settings.creds.c_str(), nullptr);
  }
  if (status == NATS_OK && !settings.nkey.empty()) {
    status = natsOptions_SetNKeyFromSeed(options, settings.nkey.c_str(), settings.seed.c_str());
  }
  if (!options_.address.tls) return status;
  if (status == NATS_OK) status = natsOptions_SetSecure(options, true);
  if (status == NATS_OK && !settings.tls.authorities.empty()) {
    status = natsOptions_LoadCATrustedCertificates(options, settings.tls.authorities.c_str());
  }
  if (status == NATS_OK && !settings.tls.certificate.empty()) {
    status = natsOptions_LoadCertificatesChain(options, settings.tls.certificate.c_str(),
                                               settings.tls.key.c_str());
  }
  return status;
}

natsStatus NatsBus::set_up_callbacks(natsOptions* options, Held* held) {
  natsStatus status = natsOptions_SetReconnectedCB(options, on_connected, held);
  if (status == NATS_OK) status = natsOptions_SetDisconnectedCB(options, on_disconnected, held);
  if (status == NATS_OK) status = natsOptions_SetErrorHandler(options, on_error, held);
  if (status == NATS_OK) status = natsOptions_SetClosedCB(options, on_closed, held);
  return status;
}

Result<void> NatsBus::open() {
  natsInbox* inbox = nullptr;
  if (natsInbox_Create(&inbox) != NATS_OK) {
    return Error{ErrorKind::Failed, "NATS gives no subject of our own"};
  }
  own_subject_ = inbox;
  natsInbox_Destroy(inbox);
  auto connected = connect();
  if (!connected && connected.error().kind == ErrorKind::Network) {
    on_given_up(connected.error().message);
    return {};
  }
  return connected;
}

/// Network: it was refused, and why. Where nobody answers it goes on by itself.
Result<void> NatsBus::connect() {
  natsStatus status = NATS_OK;
  // Why it is refused the library tells only of attempts after which it does not go on by itself.
  for (const bool goes_on : {false, true}) {
    natsOptions* created = nullptr;
    status = natsOptions_Create(&created);
    const OptionsPtr options(created);
    if (status == NATS_OK) status = set_up(options.get());
    if (status == NATS_OK) status = set_up_secrets(options.get());
    auto held = std::make_unique<Held>(gate_);
    if (status == NATS_OK) status = set_up_callbacks(options.get(), held.get());
    if (status == NATS_OK && goes_on) {
      status = natsOptions_SetRetryOnFailedConnect(options.get(), true, on_connected, held.get());
    }
    if (status != NATS_OK) {
      return Error{ErrorKind::Usage, "NATS does not take these options: " + reason_of(status)};
    }
    status = natsConnection_Connect(&connection_, options.get());
    if (connection_ != nullptr) {
      // From here on on_closed() has it.
      Held* const given = held.release();
      if (status == NATS_OK) {
        on_connected(connection_, given);
      } else {
        spdlog::warn("no server of NATS answers yet; they are tried on");
      }
      return {};
    }
    if (!may_come_yet(status)) break;
  }
  return Error{ErrorKind::Network, reason_of(status)};
}

void NatsBus::subscribe(const std::string& subject) {
  subjects_.push_back(subject);
  if (connection_ != nullptr) add_subscription(subject);
}

void NatsBus::add_subscription(const std::string& subject) {
  auto held = std::make_unique<Held>(gate_);
  natsSubscription* subscription = nullptr;
  natsStatus status =
      natsConnection_Subscribe(&subscription, connection_, subject.c_str(), on_message, held.get());
  if (status == NATS_OK) {
    subscriptions_.push_back(subscription);
    status = natsSubscription_SetOnCompleteCB(subscription, let_go, held.get());
  }
  // From here on let_go() has it, or the library may still use it.
  if (subscription != nullptr) static_cast<void>(held.release());
  // Who hears nothing is as good as refused.
  if (status != NATS_OK) on_given_up("no subscription to " + subject + ": " + reason_of(status));
}

void NatsBus::publish(const Message& message) {
  if (connection_ == nullptr) return;
  const auto size = static_cast<int>(message.bytes.size());
  const natsStatus status =
      message.reply_to.empty()
          ? natsConnection_Publish(connection_, message.subject.c_str(), message.bytes.data(), size)
          : natsConnection_PublishRequest(connection_, message.subject.c_str(),
                                          message.reply_to.c_str(), message.bytes.data(), size);
  if (status != NATS_OK) spdlog::debug("{}: not published: {}", message.subject, reason_of(status));
}

}  // namespace

Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io, const NatsOptions& options,
                                           Bus::Events events) {
  auto bus = std::make_unique<NatsBus>(io, options, std::move(events));
  if (auto opened = bus->open(); !opened) return opened.error();
  return std::unique_ptr<Bus>(std::move(bus));
}

}  // namespace aucast::server
