#pragma once

#include <cstddef>

namespace aucast::test {

/// How often this thread has called operator new. A program that calls this has an operator new of
/// its own, which counts; under Clang's sanitizers their operator new counts.
[[nodiscard]] std::size_t allocations();

}  // namespace aucast::test
