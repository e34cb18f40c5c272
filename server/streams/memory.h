#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "common/result.h"

namespace aucast::server {

/// Left for everything else when a stream is read.
inline constexpr std::uint64_t kMemoryReserve = std::uint64_t{64} << 20U;

/// Bytes that this process may still take: the least of what the machine has available, what its
/// control group allows and what `ulimit -v` allows. nullopt when none of these is known.
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// Whether the file at `path` may take `bytes` more with kMemoryReserve left; else an error that
/// says so. Without this check the system would rather kill the process than refuse it memory.
[[nodiscard]] Result<void> check_memory(const std::filesystem::path& path, std::uint64_t bytes);

}  // namespace aucast::server
