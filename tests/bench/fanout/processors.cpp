#include "tests/bench/fanout/processors.h"

#include <sys/resource.h>

namespace aucast::bench {
namespace {

constexpr int kNice = 5;

}  // namespace

std::vector<std::size_t> usable_processors() {
  cpu_set_t set{};
  std::vector<std::size_t> numbers;
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return numbers;
  for (std::size_t number = 0; number < CPU_SETSIZE; ++number) {
    if (CPU_ISSET(number, &set)) numbers.push_back(number);
  }
  return numbers;
}

OnProcessor::OnProcessor(std::optional<std::size_t> number) {
  ::sched_getaffinity(0, sizeof before_, &before_);
  if (!number) return;
  cpu_set_t only{};
  CPU_SET(*number, &only);
  ::sched_setaffinity(0, sizeof only, &only);
}

OnProcessor::~OnProcessor() {
  ::sched_setaffinity(0, sizeof before_, &before_);
}

void stand_back() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_OTHER, &none);
  ::setpriority(PRIO_PROCESS, 0, kNice);  // of this thread only
}

}  // namespace aucast::bench
