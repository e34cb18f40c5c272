#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/result.h"
#include "server/engine/bus.h"

namespace aucast::server {

// The interface between the program and the module aucast-nats.so. The event loop, the log, the
// clock and the files are the program's; the module has only libnats. Code compiled into both has
// no state, and neither needs a symbol of the other. So no variable exists twice, and neither side
// has to catch or cast what the other made.

/// The addresses of NATS servers, and the credentials for them. Empty members are not used.
struct NatsServers {
  std::vector<std::string> urls;  ///< in the order in which they are tried
  bool tls = false;
  std::string token;
  std::string user;
  std::string password;
  std::string creds;  ///< a file, like all members below except the nkey
  std::string nkey;
  std::string seed;
  std::string authorities;
  std::string certificate;
  std::string key;
};

/// Hears about a connection. Texts are the library's own. Called on the library's threads, even
/// after the connection's end.
class NatsListener {
 public:
  NatsListener() = default;
  virtual ~NatsListener() = default;
  NatsListener(const NatsListener&) = delete;
  NatsListener& operator=(const NatsListener&) = delete;

  virtual void on_connected(const std::string& server) = 0;
  virtual void on_disconnected() = 0;
  virtual void on_message(Bus::Message message) = 0;
  virtual void on_error(const std::string& text) = 0;
  /// The library has given up.
  virtual void on_given_up(const std::string& why) = 0;
};

/// A connection. The library tries to connect again and again, unless it is refused. Thread: one at
/// a time.
class NatsConnection {
 public:
  NatsConnection() = default;
  /// Waits a moment for the last messages to be sent.
  virtual ~NatsConnection() = default;
  NatsConnection(const NatsConnection&) = delete;
  NatsConnection& operator=(const NatsConnection&) = delete;

  [[nodiscard]] virtual bool is_connected() const = 0;
  [[nodiscard]] virtual Result<void> subscribe(const std::string& subject) = 0;
  [[nodiscard]] virtual Result<void> send(const Bus::Message& message) = 0;
};

/// The object that the module exports, under the name kNatsModule.
struct NatsModule {
  /// Must stay the first member, however the others change: the loader reads no further if it
  /// differs from the program's own AUCAST_NATS_TAG. server/CMakeLists.txt makes the tag from the
  /// version, the text of the shared headers, the compiler and the sanitizer.
  const char* tag;
  /// Takes up to a second for each server that does not answer. Fails with a Network error if a
  /// server refuses us, with a Usage error if the library refuses the options. The messages are the
  /// library's own.
  Result<std::unique_ptr<NatsConnection>> (*connect)(const NatsServers& servers,
                                                     const std::shared_ptr<NatsListener>& listener);
  /// As Bus::own_subject().
  Result<std::string> (*new_subject)();
};

inline constexpr const char* kNatsModule = "aucast_nats_module";

}  // namespace aucast::server
