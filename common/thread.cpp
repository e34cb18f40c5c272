#include "common/thread.h"

#include <system_error>
#include <utility>

#include "common/text.h"

namespace aucast {

Result<std::jthread> start_thread(std::function<void()> work) {
  try {
    return std::jthread(std::move(work));
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Failed, shortage_text(failure)};
  }
}

Result<void> start_unattended(std::function<void()> work) {
  auto thread = start_thread(std::move(work));
  if (!thread) return thread.error();
  thread->detach();
  return {};
}

}  // namespace aucast
