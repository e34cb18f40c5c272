#pragma once

#include <cstddef>

namespace aucast::test {

/// How often this thread has called operator new. In a program that calls this, operator new is
/// replaced by one that counts its calls; under Clang's sanitizers, their own operator new counts
/// them.
[[nodiscard]] std::size_t allocations();

}  // namespace aucast::test
