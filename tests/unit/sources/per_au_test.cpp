#include "common/sources/per_au.h"

#include <gtest/gtest.h>

namespace aucast::sources {
namespace {

TEST(PerAu, NamesAreThoseOfPackets) {
  EXPECT_EQ(parse_au_name("12"), (AuName{12, Side::Both}));
  EXPECT_EQ(parse_au_name("L1"), (AuName{1, Side::Left}));
  EXPECT_EQ(parse_au_name("R99"), (AuName{99, Side::Right}));
  for (const char* wrong : {"", "0", "100", "-1", "L", "l12", "12L", "AU12", "12 ", "1.0", "+1"}) {
    EXPECT_FALSE(parse_au_name(wrong)) << wrong;
  }
  for (const char* name : {"12", "L1", "R99"}) EXPECT_EQ(au_name_text(*parse_au_name(name)), name);
}

TEST(PerAu, EveryOneHasTheNumberOfAllUntilItGetsItsOwn) {
  PerAu table(2);
  EXPECT_EQ(table.of(12, false), 2);
  EXPECT_TRUE(table.exceptions().empty());
  table.set({12, Side::Both}, 5);
  table.set({12, Side::Right}, 3);
  table.set({45, Side::Both}, 0);
  table.set({1, Side::Left}, 7);
  EXPECT_EQ(table.of(12, false), 5);
  EXPECT_EQ(table.of(12, true), 3);
  using Exceptions = std::vector<std::pair<AuName, double>>;
  EXPECT_EQ(table.exceptions(), (Exceptions{{{1, Side::Left}, 7},
                                            {{12, Side::Left}, 5},
                                            {{12, Side::Right}, 3},
                                            {{45, Side::Both}, 0}}));
  table.set_all(4);
  EXPECT_EQ(table, PerAu(4)) << "all means all";
}

}  // namespace
}  // namespace aucast::sources
