#include "common/error_list.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(ErrorList, NamesThePlacesOfTheFirstAndCountsTheRest) {
  ErrorList errors("f.txt");
  EXPECT_TRUE(errors.empty());
  errors.add(3, 7, "bad");
  EXPECT_FALSE(errors.empty());
  EXPECT_EQ(errors.error().kind, ErrorKind::BadData);
  EXPECT_EQ(errors.error().message, "f.txt:3:7: bad");
  for (std::size_t line = 4; line < 4 + kReportedErrorsMax; ++line) errors.add(line, 1, "worse");
  EXPECT_TRUE(errors.error().message.starts_with("f.txt:3:7: bad\nf.txt:4:1: worse\n"));
  EXPECT_TRUE(errors.error().message.ends_with("\nf.txt:22:1: worse\nf.txt: and 1 more errors"));
  EXPECT_EQ(errors.take().size(), kReportedErrorsMax);
  EXPECT_TRUE(errors.empty());
  EXPECT_TRUE(errors.take().empty());
}

}  // namespace
}  // namespace aucast
