#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace aucast::test {

/// Lets this process take `bytes` of memory more than it has, for as long as the object lives, as
/// `ulimit -v` would.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::uint64_t bytes) {
    ::getrlimit(RLIMIT_AS, &before_);
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = before_;
    limit.rlim_cur = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + bytes;
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
};

/// A stream file of `keyframes` times AU 1: two bytes each, so that it takes far more in memory.
inline std::string short_lines(std::size_t keyframes) {
  std::string text = "Beg_Stream\n";
  for (std::size_t i = 0; i < keyframes; ++i) text += "1\n";
  return text + "End_Stream\n";
}

}  // namespace aucast::test
