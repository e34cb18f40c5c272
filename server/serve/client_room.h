#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace aucast::server {

/// What this process can use for clients; nullopt: not known.
struct ClientRoom {
  std::optional<std::uint64_t> memory_bytes;
  std::optional<std::uint64_t> descriptors;
};

/// The memory that this process may still take, and the descriptors that it may have in all.
[[nodiscard]] ClientRoom room_now();

/// How many clients there is room for, at least one. Each takes a descriptor and, if it reads
/// nothing, up to kOutputBytesMax of memory. kDescriptorsKept descriptors are kept free, unless the
/// process may have fewer than twice that number of descriptors.
[[nodiscard]] std::size_t clients_with_room(const ClientRoom& room);

}  // namespace aucast::server
