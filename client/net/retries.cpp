#include "client/net/retries.h"

namespace aucast::net {

using protocol::SessionFailed;

std::optional<Milliseconds> Retries::unreachable(Keyframes came) {
  busy_in_a_row_ = 0;
  return again(came);
}

std::optional<Milliseconds> Retries::failed(const SessionFailed& event, Keyframes came) {
  const bool lost =
      event.why == SessionFailed::Why::Lost || event.why == SessionFailed::Why::Silent;
  // Another server may have room, or have the stream already.
  busy_in_a_row_ = event.code == protocol::kBusy ? busy_in_a_row_ + 1 : 0;
  const bool elsewhere = busy_in_a_row_ > 0 && busy_in_a_row_ < options_.hosts;
  // A stream that was here comes again: its server may have begun anew, or be full for now.
  const bool later =
      came.earlier && (event.code == protocol::kBusy || event.code == protocol::kNoSuchStream);
  return lost || elsewhere || later ? again(came) : std::nullopt;
}

std::optional<Milliseconds> Retries::again(Keyframes came) {
  if (!options_.reconnect) return std::nullopt;
  const bool reached = granted_ || came.earlier || came.now;
  if (options_.one_round && !reached && ++failures_ >= options_.hosts) return std::nullopt;
  return back_off_.next();
}

}  // namespace aucast::net
