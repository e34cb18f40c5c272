#include "client/net/stream_list.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include <asio/io_context.hpp>

#include "client/net/dialling.h"
#include "client/net/stream_question.h"
#include "common/link/host.h"
#include "common/text.h"

namespace aucast::net {
namespace {

/// Dials and asks. Everything runs in the calling thread.
Result<protocol::StreamList> ask(const RemoteOptions& options, const link::DialOptions& dial) {
  const std::string server = link::host_and_port(dial.host, dial.port);
  std::optional<Result<protocol::StreamList>> answer;
  asio::io_context io{1};
  link::Dialler dialler{io};
  StreamQuestion question({.server = server,
                           .token = options.security.token,
                           .until = std::chrono::steady_clock::now() + options.connect_timeout,
                           .remedy = "--connect-timeout sets how long to wait"},
                          [&](Result<protocol::StreamList> result) { answer = std::move(result); });
  dialler.dial(dial, [&](link::Dialled dialled) {
    if (auto* const link = std::get_if<std::shared_ptr<link::Link>>(&dialled)) {
      question.ask(std::move(*link));
    } else {
      const auto& failure = std::get<link::DialFailure>(dialled);
      question.abandon((failure.final ? "" : "cannot be reached: ") + failure.reason);
    }
  });
  io.run();
  return std::move(*answer);
}

}  // namespace

Result<protocol::StreamList> list_streams(const RemoteOptions& options, Duration time_max) {
  const Instant begun = std::chrono::steady_clock::now();
  RemoteOptions one = options;
  std::string failures;
  const std::size_t hosts = options.others.size() + 1;
  for (std::size_t host = 0; host < hosts; ++host) {
    const Duration left = time_max - (std::chrono::steady_clock::now() - begun);
    if (left <= Duration::zero()) break;
    // A silent server leaves time for those after it.
    const Duration share = left / static_cast<Duration::rep>(hosts - host);
    one.connect_timeout = std::min<Duration>(options.connect_timeout, share);
    const link::DialOptions dial = dial_options(one, host);
    if (!failures.empty()) failures += '\n';
    // Asio throws when the system has no descriptor left for it.
    try {
      auto list = ask(one, dial);
      if (list) return list;
      failures += list.error().message;
    } catch (const std::system_error& failure) {
      failures += link::host_and_port(dial.host, dial.port) + ": " + shortage_text(failure);
    }
  }
  return Error{ErrorKind::Network, failures};
}

}  // namespace aucast::net
