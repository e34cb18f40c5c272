#include "common/thread.h"

#include "common/shared.h"

namespace aucast {

void sleep_until(const std::stop_token& stop, Instant until) {
  // There is nothing to be told of but the stop.
  Shared<bool> nothing{false};
  nothing.wait_until(
      stop, until, [](bool) { return false; }, [](bool) {});
}

Result<void> start_unattended(std::function<void()> work) {
  auto thread = start_thread(std::move(work));
  if (!thread) return thread.error();
  thread->detach();
  return {};
}

}  // namespace aucast
