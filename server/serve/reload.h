#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>

#include <asio/io_context.hpp>

#include "common/link/loop_gate.h"
#include "common/result.h"
#include "server/serve/credentials.h"
#include "server/serve/programme.h"
#include "server/streams/load_repertoire.h"

namespace aucast::server {

/// Reads certificates, tokens, profile and sources again on SIGHUP, on a thread of its own, so that
/// no client waits for a disk. Takes over all of it or, if anything cannot be read, nothing.
/// Thread: that of the io_context, where `on_done` is called too. The load function runs on the
/// other thread, must not touch what the io_context's thread uses, and returns soon when asked to
/// stop.
class Reload {
 public:
  using Load = std::function<Result<LoadedSources>(const std::stop_token& stop)>;
  struct Outcome {
    bool changed = false;  ///< clients that connect from now on get other streams
    bool last = true;      ///< no other reload was waiting for the end of this one
  };
  using OnDone = std::function<void(const Outcome& outcome)>;

  /// Replaces `certificates`, and tokens, streams and conditioning of `programme`. Everything that
  /// is passed by reference must outlive this object. The destructor stops a load that is under
  /// way, and waits for it.
  Reload(asio::io_context& io, const CredentialFiles& files, Certificates& certificates,
         Programme& programme, Load load, OnDone on_done);
  ~Reload();
  Reload(const Reload&) = delete;
  Reload& operator=(const Reload&) = delete;

  /// Reads the certificates and tokens alone, for the start.
  [[nodiscard]] Result<void> read_credentials();
  /// Reads everything again. If that is being done already, it is done once more afterwards.
  void start();
  /// Asks a load that is under way to stop.
  void stop() { thread_.request_stop(); }

  /// Whether anything is being read.
  [[nodiscard]] bool running() const { return running_; }
  /// How many reloads took over everything, and how many nothing.
  [[nodiscard]] std::uint64_t successes() const { return successes_; }
  [[nodiscard]] std::uint64_t failures() const { return failures_; }

 private:
  struct Loaded {
    Credentials credentials;
    LoadedSources sources;
  };

  void read();
  // These three run on the other thread. `result`: what is told if nothing else can be.
  void load(const std::stop_token& stop, const std::shared_ptr<Result<Loaded>>& result);
  [[nodiscard]] Result<Loaded> loaded(const std::stop_token& stop) const;
  [[nodiscard]] bool post(const std::shared_ptr<Result<Loaded>>& result);
  void done(Result<Loaded> loaded);
  [[nodiscard]] bool take_over(Result<Loaded> loaded);
  void use(Credentials credentials);

  std::shared_ptr<link::LoopGate> gate_;
  const CredentialFiles& files_;
  Certificates& certificates_;
  Programme& programme_;
  Load load_;
  OnDone on_done_;
  std::uint64_t successes_ = 0;
  std::uint64_t failures_ = 0;
  bool running_ = false;
  bool again_ = false;   ///< another reload waits for the end of this one
  std::jthread thread_;  ///< last: it ends before anything it uses is gone
};

}  // namespace aucast::server
