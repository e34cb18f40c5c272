#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/result.h"
#include "server/engine/bus.h"

namespace aucast::server {

// What program and module (aucast-nats.so) agree on: the program has loop, log, clock and files,
// the module has libnats, and no more. What is compiled into both has no state, and neither needs a
// symbol of the other, so that nothing exists twice and no type has to be recognised by both.

/// Where servers of NATS are and what is shown to them. Empty: nothing.
struct NatsServers {
  std::vector<std::string> urls;  ///< in the order in which they are tried
  bool tls = false;
  std::string token;
  std::string user;
  std::string password;
  std::string creds;  ///< a file, as are all below but the nkey
  std::string nkey;
  std::string seed;
  std::string authorities;
  std::string certificate;
  std::string key;
};

/// Is told what becomes of a connection, in the words of the library and on its threads, even after
/// the connection's end.
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
  /// The library gives up.
  virtual void on_given_up(const std::string& why) = 0;
};

/// A connection; the library tries for ever, unless it is refused. Thread: one at a time.
class NatsConnection {
 public:
  NatsConnection() = default;
  /// Waits a moment for the last messages to go out.
  virtual ~NatsConnection() = default;
  NatsConnection(const NatsConnection&) = delete;
  NatsConnection& operator=(const NatsConnection&) = delete;

  [[nodiscard]] virtual bool is_connected() const = 0;
  [[nodiscard]] virtual Result<void> subscribe(const std::string& subject) = 0;
  [[nodiscard]] virtual Result<void> send(const Bus::Message& message) = 0;
};

/// What the module exports, under the name kNatsModule.
struct NatsModule {
  /// Stays the first member whatever becomes of the rest: the loader reads no further if it differs
  /// from its own kNatsTag, AUCAST_NATS_TAG. server/CMakeLists.txt makes that of the version, of
  /// the text of the headers that the two share, of the compiler and of the sanitizer.
  const char* tag;
  /// Takes up to a second for each server that does not answer. Network: it was refused; usage: the
  /// library does not take these options. Messages are the library's own words.
  Result<std::unique_ptr<NatsConnection>> (*connect)(const NatsServers& servers,
                                                     const std::shared_ptr<NatsListener>& listener);
  /// A subject of our own, to which answers may go.
  Result<std::string> (*new_subject)();
};

inline constexpr const char* kNatsModule = "aucast_nats_module";

}  // namespace aucast::server
