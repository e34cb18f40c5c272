#include "server/serve/reload.h"

#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "common/log.h"
#include "common/thread.h"
#include "common/time.h"

namespace aucast::server {
namespace {

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
  certificates_ = std::move(loaded->certificates);
  programme_.set_tokens(std::move(loaded->token), std::move(loaded->publishers));
  return {};
}

void Reload::start() {
  const auto read = read_credentials();
  if (!read) {
    spdlog::error("{}; the certificates and token in use stay", read.error().message);
  } else {
    spdlog::info("certificates and token were read again");
  }
  programme_.condition_sources_anew();
  if (running_) {
    next_failed_ = !read;
  } else {
    read_sources(!read);
  }
}

void Reload::read_sources(bool failed) {
  failed_ = failed;
  // A failure to load is a Result; what else can be thrown is the lack of memory.
  const auto result =
      std::make_shared<Result<Repertoire>>(Error{ErrorKind::Failed, "not enough memory"});
  auto started = start_thread([this, result] { load(result); });
  if (started) {
    thread_ = std::move(*started);
    running_ = true;
  } else {
    ++failures_;
    spdlog::error("the sources were not read again: {}", started.error().message);
    on_done_({});
  }
}

void Reload::load(const std::shared_ptr<Result<Repertoire>>& result) {
  try {
    *result = load_(stop_.get_token());
  } catch (const std::bad_alloc&) {
  }
  // Who waits for the end of the reload must learn of it, if only when there is memory again.
  while (!post(result) && !stop_.stop_requested()) std::this_thread::sleep_for(kPostAgainAfter);
}

bool Reload::post(const std::shared_ptr<Result<Repertoire>>& result) {
  try {
    gate_->post([this, result] { done(std::move(*result)); });
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void Reload::done(Result<Repertoire> loaded) {
  running_ = false;
  if (programme_.stopped()) return;
  const bool changed = take_over(std::move(loaded));
  const auto next_failed = std::exchange(next_failed_, std::nullopt);
  on_done_({changed, !next_failed});
  if (next_failed) read_sources(*next_failed);
}

bool Reload::take_over(Result<Repertoire> loaded) {
  ++(loaded && !failed_ ? successes_ : failures_);
  if (loaded) return programme_.take_over(std::move(*loaded));
  std::istringstream lines(loaded.error().message);
  for (std::string line; std::getline(lines, line);) spdlog::error("{}", line);
  spdlog::error("the sources were not taken over; what was served before is served on");
  return false;
}

}  // namespace aucast::server
