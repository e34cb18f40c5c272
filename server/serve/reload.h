#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>

#include <asio/io_context.hpp>

#include "common/link/loop_gate.h"
#include "common/result.h"
#include "server/serve/credentials.h"
#include "server/serve/programme.h"
#include "server/streams/repertoire.h"

namespace aucast::server {

/// What SIGHUP reads again: certificates, token and profile at once, the sources on a thread of
/// their own, so that nobody who is being served waits for a disk. What cannot be read changes
/// nothing. Thread: that of the io_context, where `on_done` is called too; the load function runs
/// on the other one, must not touch what the first one uses, and returns soon when asked to stop.
class Reload {
 public:
  using Load = std::function<Result<Repertoire>(const std::stop_token& stop)>;
  /// `changed`: clients that connect from now on get other streams.
  using OnDone = std::function<void(bool changed)>;

  /// Replaces `certificates` and what `programme` has. All references must outlive it. The
  /// destructor stops a load that is under way, and waits for it.
  Reload(asio::io_context& io, const CredentialFiles& files, Certificates& certificates,
         Programme& programme, Load load, OnDone on_done);
  ~Reload();
  Reload(const Reload&) = delete;
  Reload& operator=(const Reload&) = delete;

  /// Certificates and token; at the start too.
  [[nodiscard]] Result<void> read_credentials();
  /// All, now; the sources once more afterwards if they are being read already.
  void start();
  /// Nothing is read any more, and what is being read is given up.
  void stop() { stop_.request_stop(); }

  /// Sources are being read.
  [[nodiscard]] bool running() const { return running_; }
  /// Those of which everything was taken over, and the others.
  [[nodiscard]] std::uint64_t successes() const { return successes_; }
  [[nodiscard]] std::uint64_t failures() const { return failures_; }

 private:
  void read_sources(bool failed);
  void load();  ///< on the thread of its own
  void done(Result<Repertoire> loaded);
  [[nodiscard]] bool take_over(Result<Repertoire> loaded);

  std::shared_ptr<link::LoopGate> gate_;
  const CredentialFiles& files_;
  Certificates& certificates_;
  Programme& programme_;
  Load load_;
  OnDone on_done_;
  std::uint64_t successes_ = 0;
  std::uint64_t failures_ = 0;
  bool failed_ = false;  ///< the certificates and token of the order that is carried out
  bool running_ = false;
  std::optional<bool> next_failed_;  ///< the same of the latest order that came meanwhile
  std::stop_source stop_;
  std::jthread thread_;
};

}  // namespace aucast::server
