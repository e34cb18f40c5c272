// The module aucast-nats.so: all that is linked with libnats. NatsModule says what it may use.
#include <nats/nats.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/engine/nats_library.h"

namespace aucast::server {
namespace {

/// For each server that does not answer. At the start, the loop waits for this.
constexpr int kConnectMs = 1'000;
constexpr int kReconnectMs = 250;  ///< between two rounds of all servers
constexpr int kReconnectJitterMs = 100;
/// A server that has vanished is noticed after the second unanswered ping.
constexpr int kPingMs = 2'000;
constexpr int kPingsUnanswered = 2;
/// How many bytes the library keeps for after a reconnect: as good as none, since they would be
/// old. 0 would mean its default, 8 MB.
constexpr int kKeptBytes = 1;
constexpr int kFlushMs = 200;  ///< for the last messages

struct OptionsDeleter {
  void operator()(natsOptions* options) const { natsOptions_Destroy(options); }
};
using OptionsPtr = std::unique_ptr<natsOptions, OptionsDeleter>;

/// The object that the library passes to its callbacks: keeps the listener alive until the last of
/// them.
using Held = std::shared_ptr<NatsListener>;

NatsListener& listener_of(void* held) {
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

// Callbacks: on threads of the library.

void on_connected(natsConnection* connection, void* held) {
  listener_of(held).on_connected(server_of(connection));
}

void on_disconnected(natsConnection* /*connection*/, void* held) {
  listener_of(held).on_disconnected();
}

std::string last_error_of(natsConnection* connection) {
  const char* last = nullptr;
  static_cast<void>(natsConnection_GetLastError(connection, &last));
  return last == nullptr ? "" : last;
}

/// The last of them for this connection: it is destroyed, or was refused twice.
void on_closed(natsConnection* connection, void* held) {
  listener_of(held).on_given_up(last_error_of(connection));
  let_go(held);
}

void on_error(natsConnection* connection, natsSubscription* /*subscription*/, natsStatus status,
              void* held) {
  listener_of(held).on_error(std::string(natsStatus_GetText(status)) + ' ' +
                             last_error_of(connection));
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
  listener_of(held).on_message(std::move(copy));
}

/// The library's text about its last failure, without the place in its sources; if there is none,
/// the status.
std::string reason_of(natsStatus status) {
  natsStatus last = status;
  const char* const said = nats_GetLastError(&last);
  std::string_view text = said == nullptr ? "" : said;
  if (text.starts_with('(')) text.remove_prefix(std::min(text.find(": "), text.size()));
  if (text.starts_with(": ")) text.remove_prefix(2);
  return text.empty() ? natsStatus_GetText(status) : std::string(text);
}

Error network_error(natsStatus status) {
  return Error{ErrorKind::Network, reason_of(status)};
}

/// Owns what the library has connected.
class Connection final : public NatsConnection {
 public:
  Connection(natsConnection* connection, std::shared_ptr<NatsListener> listener)
      : connection_(connection), listener_(std::move(listener)) {}
  ~Connection() override;

  [[nodiscard]] bool is_connected() const override {
    return natsConnection_Status(connection_) == NATS_CONN_STATUS_CONNECTED;
  }
  [[nodiscard]] Result<void> subscribe(const std::string& subject) override;
  [[nodiscard]] Result<void> send(const Bus::Message& message) override;

 private:
  natsConnection* connection_;
  std::vector<natsSubscription*> subscriptions_;
  std::shared_ptr<NatsListener> listener_;
};

Connection::~Connection() {
  if (is_connected()) static_cast<void>(natsConnection_FlushTimeout(connection_, kFlushMs));
  for (natsSubscription* const subscription : subscriptions_) {
    natsSubscription_Destroy(subscription);
  }
  natsConnection_Destroy(connection_);
}

Result<void> Connection::subscribe(const std::string& subject) {
  auto held = std::make_unique<Held>(listener_);
  natsSubscription* subscription = nullptr;
  natsStatus status =
      natsConnection_Subscribe(&subscription, connection_, subject.c_str(), on_message, held.get());
  if (status == NATS_OK) {
    subscriptions_.push_back(subscription);
    status = natsSubscription_SetOnCompleteCB(subscription, let_go, held.get());
  }
  // From here on let_go() has it, or the library may still use it.
  if (subscription != nullptr) static_cast<void>(held.release());
  return status == NATS_OK ? Result<void>() : network_error(status);
}

Result<void> Connection::send(const Bus::Message& message) {
  const auto size = static_cast<int>(message.bytes.size());
  const natsStatus status =
      message.reply_to.empty()
          ? natsConnection_Publish(connection_, message.subject.c_str(), message.bytes.data(), size)
          : natsConnection_PublishRequest(connection_, message.subject.c_str(),
                                          message.reply_to.c_str(), message.bytes.data(), size);
  return status == NATS_OK ? Result<void>() : network_error(status);
}

/// Nobody was there to refuse us.
bool may_come_yet(natsStatus status) {
  return status == NATS_NO_SERVER || status == NATS_TIMEOUT || status == NATS_IO_ERROR ||
         status == NATS_NOT_YET_CONNECTED;
}

natsStatus set_up(natsOptions* options, const NatsServers& servers) {
  std::vector<const char*> list;
  for (const std::string& url : servers.urls) list.push_back(url.c_str());
  natsStatus status = natsOptions_SetServers(options, list.data(), static_cast<int>(list.size()));
  if (status == NATS_OK) status = natsOptions_SetNoRandomize(options, true);
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

natsStatus set_up_secrets(natsOptions* options, const NatsServers& servers) {
  natsStatus status = NATS_OK;
  if (!servers.token.empty()) status = natsOptions_SetToken(options, servers.token.c_str());
  if (status == NATS_OK && !servers.user.empty()) {
    status = natsOptions_SetUserInfo(options, servers.user.c_str(), servers.password.c_str());
  }
  if (status == NATS_OK && !servers.creds.empty()) {
    status = natsOptions_SetUserCredentialsFromFiles(options, servers.creds.c_str(), nullptr);
  }
  if (status == NATS_OK && !servers.nkey.empty()) {
    status = natsOptions_SetNKeyFromSeed(options, servers.nkey.c_str(), servers.seed.c_str());
  }
  if (!servers.tls) return status;
  if (status == NATS_OK) status = natsOptions_SetSecure(options, true);
  if (status == NATS_OK && !servers.authorities.empty()) {
    status = natsOptions_LoadCATrustedCertificates(options, servers.authorities.c_str());
  }
  if (status == NATS_OK && !servers.certificate.empty()) {
    status = natsOptions_LoadCertificatesChain(options, servers.certificate.c_str(),
                                               servers.key.c_str());
  }
  return status;
}

natsStatus set_up_callbacks(natsOptions* options, Held* held) {
  natsStatus status = natsOptions_SetReconnectedCB(options, on_connected, held);
  if (status == NATS_OK) status = natsOptions_SetDisconnectedCB(options, on_disconnected, held);
  if (status == NATS_OK) status = natsOptions_SetErrorHandler(options, on_error, held);
  if (status == NATS_OK) status = natsOptions_SetClosedCB(options, on_closed, held);
  return status;
}

Result<std::unique_ptr<NatsConnection>> connect(const NatsServers& servers,
                                                const std::shared_ptr<NatsListener>& listener) {
  natsStatus status = NATS_OK;
  // Why it is refused the library tells only of attempts after which it does not go on by itself.
  for (const bool goes_on : {false, true}) {
    natsOptions* created = nullptr;
    status = natsOptions_Create(&created);
    const OptionsPtr options(created);
    if (status == NATS_OK) status = set_up(options.get(), servers);
    if (status == NATS_OK) status = set_up_secrets(options.get(), servers);
    auto held = std::make_unique<Held>(listener);
    if (status == NATS_OK) status = set_up_callbacks(options.get(), held.get());
    if (status == NATS_OK && goes_on) {
      status = natsOptions_SetRetryOnFailedConnect(options.get(), true, on_connected, held.get());
    }
    if (status != NATS_OK) return Error{ErrorKind::Usage, reason_of(status)};
    natsConnection* connection = nullptr;
    status = natsConnection_Connect(&connection, options.get());
    if (connection != nullptr) {
      static_cast<void>(held.release());  // on_closed() has it, and may have let it go already
      if (status == NATS_OK) listener->on_connected(server_of(connection));
      return std::unique_ptr<NatsConnection>(std::make_unique<Connection>(connection, listener));
    }
    if (!may_come_yet(status)) break;
  }
  return network_error(status);
}

Result<std::string> new_subject() {
  natsInbox* inbox = nullptr;
  const natsStatus status = natsInbox_Create(&inbox);
  if (status != NATS_OK) return Error{ErrorKind::Failed, reason_of(status)};
  std::string subject = inbox;
  natsInbox_Destroy(inbox);
  return subject;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const NatsModule aucast_nats_module;
extern "C" const NatsModule aucast_nats_module{AUCAST_NATS_TAG, connect, new_subject};

}  // namespace aucast::server
