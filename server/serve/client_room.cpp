#include "server/serve/client_room.h"

#include <sys/resource.h>

#include <algorithm>
#include <limits>

#include "common/memory.h"
#include "protocol/limits.h"
#include "server/settings/limits.h"

namespace aucast::server {

ClientRoom room_now() {
  ClientRoom room{available_memory(), std::nullopt};
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    room.descriptors = limit.rlim_cur;
  }
  return room;
}

std::size_t clients_with_room(const ClientRoom& room) {
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  if (room.memory_bytes) most = *room.memory_bytes / protocol::kOutputBytesMax;
  if (room.descriptors) {
    // Where there are few, nobody is refused for the sake of those that may never be needed.
    const bool few = *room.descriptors < 2 * kDescriptorsKept;
    most = std::min(most, few ? *room.descriptors : *room.descriptors - kDescriptorsKept);
  }
  return std::max<std::uint64_t>(most, 1);
}

}  // namespace aucast::server
