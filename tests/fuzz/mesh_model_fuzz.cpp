#include <cstddef>
#include <cstdint>

#include "common/mesh/net.h"

/// A model file of anybody's: a net, which can be run then, or bad data.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto net = aucast::mesh::Net::make({data, size}, "fuzz");
  if (net.has_value()) net->run();
  return 0;
}
