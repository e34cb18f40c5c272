#include "common/link/dialler.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "common/link/host.h"
#include "common/link/tcp_link.h"
#include "common/link/tls_link.h"

namespace aucast::link {
namespace {

using std::chrono::steady_clock;

constexpr const char* kIsItThere =
    "is au-transmitter running there, on an address that can be reached from here?";

}  // namespace

void Dialler::dial(DialOptions options, OnDialled on_dialled) {
  cancel();
  options_ = std::move(options);
  on_dialled_ = std::move(on_dialled);
  until_ = steady_clock::now() + options_.time_max;
  addresses_.clear();
  next_address_ = 0;
  first_failure_.clear();

  lookup_.start(options_.host, options_.port, [this](const std::string& failure, Addresses found) {
    if (!failure.empty()) {
      end(DialFailure{false, failure});
      return;
    }
    addresses_ = std::move(found);
    try_next_address();
  });
  timer_.expires_at(until_);
  timer_.async_wait([this, attempt = attempts_.begin()](const std::error_code& error) {
    if (error || !attempt.current()) return;
    fail("its name could not be looked up within " + time_text(options_.time_max),
         "check the network or give the address in numbers");
  });
}

void Dialler::cancel() {
  on_dialled_ = nullptr;
  lookup_.cancel();
  timer_.cancel();
  drop_socket();
}

void Dialler::drop_socket() {
  attempts_.cancel();
  std::error_code ignored;
  socket_.close(ignored);
}

/// Each address has an equal share of the time, so that one that never answers leaves time for the
/// others.
void Dialler::try_next_address() {
  drop_socket();
  const auto left = until_ - steady_clock::now();
  if (next_address_ == addresses_.size() || left <= Duration::zero()) {
    fail(first_failure_.empty() ? "no answer within " + time_text(options_.time_max)
                                : first_failure_,
         kIsItThere);
    return;
  }
  const auto addresses_left = static_cast<Duration::rep>(addresses_.size() - next_address_);
  const Waits::Token attempt = attempts_.begin();
  timer_.expires_after(left / addresses_left);
  timer_.async_wait([this, attempt](const std::error_code& error) {
    if (!error && attempt.current()) try_next_address();
  });
  socket_.async_connect(addresses_[next_address_++], [this, attempt](const std::error_code& error) {
    if (!attempt.current()) return;
    if (!error) {
      on_connected();
      return;
    }
    if (first_failure_.empty()) first_failure_ = error.message();
    try_next_address();
  });
}

void Dialler::on_connected() {
  std::error_code unknown;
  const auto peer = socket_.remote_endpoint(unknown);
  // The name may have led elsewhere than to this computer.
  if (options_.secret && !options_.tls && (unknown || !peer.address().is_loopback())) {
    end(DialFailure{
        true, std::string("everybody on the way could read the token; ") + options_.secret_remedy});
    return;
  }
  std::shared_ptr<Link> link =
      tcp_link(std::move(socket_), options_.limits, options_.held_back_max);
  if (options_.tls) {
    Limits limits = options_.limits;
    limits.tls_handshake =
        std::max(Milliseconds{0}, std::chrono::ceil<Milliseconds>(until_ - steady_clock::now()));
    link = tls_link(std::move(link), tls::Layer(*options_.tls, options_.host), limits);
  }
  end(std::move(link));
}

void Dialler::fail(std::string cause, const char* remedy) {
  end(DialFailure{false, std::move(cause) + "; " + remedy});
}

void Dialler::end(Dialled dialled) {
  const OnDialled on_dialled = std::exchange(on_dialled_, nullptr);
  cancel();
  on_dialled(std::move(dialled));
}

}  // namespace aucast::link
