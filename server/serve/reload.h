#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
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
/// on the other one and must not touch what the first one uses.
class Reload {
 public:
  using Load = std::function<Result<Repertoire>()>;
  /// `changed`: clients that connect from now on get other streams.
  using OnDone = std::function<void(bool changed)>;

  /// Replaces `certificates` and what `programme` has. All references must outlive it. Waits in its
  /// destructor for a load that is under way: an owner that must not wait keeps it, and all that
  /// the load uses, until the process ends.
  Reload(asio::io_context& io, const CredentialFiles& files, Certificates& certificates,
         Programme& programme, Load load, OnDone on_done);
  ~Reload();
  Reload(const Reload&) = delete;
  Reload& operator=(const Reload&) = delete;

  /// Certificates and token; at the start too.
  [[nodiscard]] Result<void> read_credentials();
  /// All, now; the sources once more afterwards if they are being read already.
  void start();

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
  std::jthread thread_;
};

}  // namespace aucast::server
