#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "common/result.h"

namespace aucast::server {

/// Left for everything else when a stream is read.
inline constexpr std::uint64_t kMemoryReserve = std::uint64_t{64} << 20U;

/// Bytes that this process may still take: what the machine has available, what its control group
/// leaves and what `ulimit -v` does, the least of them. Nothing when none is known.
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// Whether `bytes` more may be taken for the file at `path` with kMemoryReserve left; else an error
/// that says so. The system would end the process sooner than refuse it memory.
[[nodiscard]] Result<void> check_memory(const std::filesystem::path& path, std::uint64_t bytes);

}  // namespace aucast::server
