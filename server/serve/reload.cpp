#include "server/serve/reload.h"

#include <chrono>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "common/log.h"
#include "common/thread.h"
#include "common/time.h"

namespace aucast::server {
namespace {

/// On the thread that reads: the loop, and so the clients, do not wait.
constexpr Milliseconds kPostAgainAfter{100};

}  // namespace

Reload::Reload(asio::io_context& io, const CredentialFiles& files, Certificates& certificates,
               Programme& programme, Load load, OnDone on_done)
    : gate_(std::make_shared<link::LoopGate>(io)),
      files_(files),
      certificates_(certificates),
      programme_(programme),
      load_(std::move(load)),
      on_done_(std::move(on_done)) {}

Reload::~Reload() {
  stop();
  if (thread_.joinable()) thread_.join();
  // What the thread has posted may not have been carried out yet.
  gate_->close();
}

Result<void> Reload::read_credentials() {
  auto loaded = load_credentials(files_);
  if (!loaded) return loaded.error();
  use(*std::move(loaded));
  return {};
}

void Reload::use(Credentials credentials) {
  certificates_ = std::move(credentials.certificates);
  programme_.set_tokens(std::move(credentials.token), std::move(credentials.publishers));
}

void Reload::start() {
  if (running_) {
    again_ = true;
  } else {
    read();
  }
}

void Reload::read() {
  // A failure to load is a Result; what else can be thrown is the lack of memory.
  const auto result =
      std::make_shared<Result<Loaded>>(Error{ErrorKind::Failed, "not enough memory"});
  auto started = start_thread([this, result](const std::stop_token& stop) { load(stop, result); });
  if (started) {
    thread_ = std::move(*started);
    running_ = true;
  } else {
    ++failures_;
    spdlog::error("nothing was read again: {}", started.error().message);
    on_done_({});
  }
}

void Reload::load(const std::stop_token& stop, const std::shared_ptr<Result<Loaded>>& result) {
  try {
    *result = loaded(stop);
  } catch (const std::bad_alloc&) {
  }
  // Who waits for the end of the reload must learn of it, if only when there is memory again.
  while (!post(result) && !stop.stop_requested()) {
    sleep_until(stop, std::chrono::steady_clock::now() + kPostAgainAfter);
  }
}

Result<Reload::Loaded> Reload::loaded(const std::stop_token& stop) const {
  auto credentials = load_credentials(files_);
  auto sources = load_(stop);
  if (credentials && sources) return Loaded{*std::move(credentials), *std::move(sources)};
  if (credentials) return sources.error();
  if (sources) return credentials.error();
  return Error{credentials.error().kind,
               credentials.error().message + "\n" + sources.error().message};
}

bool Reload::post(const std::shared_ptr<Result<Loaded>>& result) {
  try {
    gate_->post([this, result] { done(std::move(*result)); });
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void Reload::done(Result<Loaded> loaded) {
  running_ = false;
  if (programme_.stopped()) return;
  const bool changed = take_over(std::move(loaded));
  const bool again = std::exchange(again_, false);
  on_done_({changed, !again});
  if (again) read();
}

bool Reload::take_over(Result<Loaded> loaded) {
  ++(loaded ? successes_ : failures_);
  if (loaded) {
    use(std::move(loaded->credentials));
    spdlog::info("certificates and token were read again");
    programme_.condition_sources(loaded->sources.conditioning);
    return programme_.take_over(std::move(loaded->sources.repertoire));
  }
  log_lines(spdlog::level::err, "", loaded.error().message);
  spdlog::error(
      "nothing was taken over: the certificates and token in use stay, and what was served before "
      "is served on");
  return false;
}

}  // namespace aucast::server
