#pragma once

#include <sched.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace aucast::bench {

/// The numbers of the processors that this thread may use.
[[nodiscard]] std::vector<std::size_t> usable_processors();

/// Keeps the calling thread, and what it starts meanwhile, on one processor; nullopt: on any.
class OnProcessor {
 public:
  explicit OnProcessor(std::optional<std::size_t> number);
  ~OnProcessor();  ///< allows the thread the processors that it had before
  OnProcessor(const OnProcessor&) = delete;
  OnProcessor& operator=(const OnProcessor&) = delete;

 private:
  cpu_set_t before_{};
};

/// From now on the calling thread gives way to the program's other threads and its children.
void stand_back();

}  // namespace aucast::bench
