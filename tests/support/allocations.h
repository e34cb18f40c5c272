#pragma once

#include <cstddef>

namespace aucast::test {

/// How often this thread has called operator new. A program that asks has its own operator new,
/// which counts; under Clang's sanitizers theirs counts.
[[nodiscard]] std::size_t allocations();

}  // namespace aucast::test
