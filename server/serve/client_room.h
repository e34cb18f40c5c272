#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace aucast::server {

/// What there is for clients; nothing: it is not known.
struct ClientRoom {
  std::optional<std::uint64_t> memory_bytes;
  std::optional<std::uint64_t> descriptors;
};

/// What this process may still take of memory, and all the descriptors that it may have.
[[nodiscard]] ClientRoom room_now();

/// How many clients there is room for, at least one: each takes a descriptor, with kDescriptorsKept
/// left, and up to kOutputBytesMax of memory if it reads nothing.
[[nodiscard]] std::size_t clients_with_room(const ClientRoom& room);

}  // namespace aucast::server
