#include "common/descriptor.h"

#include <fcntl.h>

#include <utility>

#include <gtest/gtest.h>

namespace aucast {
namespace {

bool is_open(int descriptor) {
  return ::fcntl(descriptor, F_GETFD) >= 0;
}

Descriptor some_file() {
  return Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC));
}

TEST(Descriptor, IsClosedWhenAnotherTakesItsPlace) {
  Descriptor one = some_file();
  Descriptor other = some_file();
  const int first = one.get();
  const int second = other.get();
  one = std::move(other);
  EXPECT_EQ(one.get(), second);
  EXPECT_TRUE(is_open(second));
  other = Descriptor();
  EXPECT_FALSE(is_open(first));
  one = Descriptor();
  EXPECT_FALSE(is_open(second)) << "at once";
  EXPECT_FALSE(one.open());
}

}  // namespace
}  // namespace aucast
