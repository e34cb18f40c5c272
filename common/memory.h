#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "common/result.h"

namespace aucast {

/// How many bytes of memory are left free for everything else when a stream is read.
inline constexpr std::uint64_t kMemoryReserve = std::uint64_t{64} << 20U;

/// How many bytes of memory are left within the limits of the control group (version 2) `group` and
/// of those above it, up to the one whose folder is `root`. The kernel takes cached files back
/// before it refuses memory, so those that were not used lately (inactive_file) count as free.
/// nullopt: there is no limit.
[[nodiscard]] std::optional<std::uint64_t> left_by_groups(const std::filesystem::path& root,
                                                          const std::filesystem::path& group);

/// How many bytes of memory this process may still take: the least of what the machine has
/// available, what its control groups allow and what `ulimit -v` allows. nullopt when none of these
/// is known.
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// Fails if `bytes` of memory for the file at `path` would leave less than kMemoryReserve free; the
/// message ends with `remedy`. Without this check the system would kill the process instead of
/// refusing the memory.
[[nodiscard]] Result<void> check_memory(const std::filesystem::path& path, std::uint64_t bytes,
                                        std::string_view remedy);

}  // namespace aucast
