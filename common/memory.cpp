#include "common/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "common/text.h"

namespace aucast {
namespace {

/// The number after `key` in a file of lines such as "MemAvailable:  123 kB".
std::optional<std::uint64_t> value_after(const std::filesystem::path& file,
                                         const std::string& key) {
  std::ifstream lines(file);
  for (std::string word; lines >> word;) {
    std::uint64_t value = 0;
    if (word == key && lines >> value) return value;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> number_in(const std::filesystem::path& file) {
  std::uint64_t value = 0;
  if (std::ifstream(file) >> value) return value;
  return std::nullopt;  // "max" too
}

std::uint64_t difference(std::uint64_t from, std::uint64_t value) {
  return from > value ? from - value : 0;
}

std::uint64_t lesser(std::optional<std::uint64_t> least, std::uint64_t value) {
  return std::min(least.value_or(value), value);
}

std::optional<std::uint64_t> left_by_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const auto pages = number_in("/proc/self/statm");
  if (!pages) return std::nullopt;
  return difference(limit.rlim_cur, *pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
}

/// Our own control group, of version 2.
std::optional<std::uint64_t> left_by_own_group() {
  std::ifstream self("/proc/self/cgroup");
  std::string line;
  if (!std::getline(self, line) || !line.starts_with("0::/")) return std::nullopt;
  return left_by_groups("/sys/fs/cgroup", line.substr(4));
}

std::string megabytes(std::uint64_t bytes) {
  return std::to_string(bytes >> 20U) + " MiB";
}

}  // namespace

std::optional<std::uint64_t> left_by_groups(const std::filesystem::path& root,
                                            const std::filesystem::path& group) {
  std::optional<std::uint64_t> least;
  const auto look_at = [&](const std::filesystem::path& folder) {
    const auto most = number_in(folder / "memory.max");
    const auto used = number_in(folder / "memory.current");
    if (!most || !used) return;
    const std::uint64_t cache = value_after(folder / "memory.stat", "inactive_file").value_or(0);
    least = lesser(least, difference(*most, difference(*used, cache)));
  };
  look_at(root);
  std::filesystem::path folder = root;
  for (const std::filesystem::path& part : group) look_at(folder /= part);
  return least;
}

std::optional<std::uint64_t> available_memory() {
  std::optional<std::uint64_t> least = left_by_own_group();
  if (const auto kib = value_after("/proc/meminfo", "MemAvailable:")) {
    least = lesser(least, *kib * 1024);
  }
  if (const auto bytes = left_by_limit()) least = lesser(least, *bytes);
  return least;
}

Result<void> check_memory(const std::filesystem::path& path, std::uint64_t bytes,
                          std::string_view remedy) {
  const auto available = available_memory();
  if (!available || *available >= bytes + kMemoryReserve) return {};
  return Error{ErrorKind::Unreadable,
               at_place(path.string(), "too large to hold: it needs " + megabytes(bytes) +
                                           " more of memory, and of " + megabytes(*available) +
                                           " that are left " + megabytes(kMemoryReserve) +
                                           " are kept free; " + std::string(remedy))};
}

}  // namespace aucast
