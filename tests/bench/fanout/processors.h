#pragma once

#include <sched.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace aucast::bench {

/// The numbers of those that this thread may use.
[[nodiscard]] std::vector<std::size_t> usable_processors();

/// Keeps the calling thread, and what it starts meanwhile, on one processor; nothing: leaves it.
class OnProcessor {
 public:
  explicit OnProcessor(std::optional<std::size_t> number);
  ~OnProcessor();  ///< back to where it was
  OnProcessor(const OnProcessor&) = delete;
  OnProcessor& operator=(const OnProcessor&) = delete;

 private:
  cpu_set_t before_{};
};

/// The calling thread gives way to the others of this program and its children from now on.
void stand_back();

}  // namespace aucast::bench
