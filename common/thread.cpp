#include "common/thread.h"

namespace aucast {

Result<void> start_unattended(std::function<void()> work) {
  auto thread = start_thread(std::move(work));
  if (!thread) return thread.error();
  thread->detach();
  return {};
}

}  // namespace aucast
