#include "client/app/stream_table.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using protocol::StreamList;

TEST(StreamTable, HasAColumnForEachThingThatIsKnown) {
  const StreamList list{{{"talk", false, 3'723'000, "A talk"},
                         {"smile.v2", true, 60'000},
                         {"a"},
                         {"b", false, std::nullopt, "Grüße"},
                         {"c", std::nullopt, std::nullopt, "Later"}}};
  EXPECT_EQ(stream_table(list),
            "talk      1:02:03   A talk\n"
            "smile.v2  live\n"
            "a\n"
            "b         recorded  Grüße\n"
            "c                   Later\n");
}

TEST(StreamTable, OfNamesAloneIsTheNames) {
  const StreamList list{{{"talk"}, {"a"}}};
  EXPECT_EQ(stream_table(list), "talk\na\n");
  EXPECT_EQ(stream_table({}), "");
}

TEST(StreamTable, ATerminalObeysNoTitle) {
  EXPECT_EQ(stream_table({{{"a", std::nullopt, std::nullopt, "\x1b[2J"}}}), "a    \\x1b[2J\n");
}

TEST(StreamNames, AreALineEachWhateverIsKnown) {
  EXPECT_EQ(stream_names({{{"talk", false, 60'000, "A talk"}, {"a", true}}}), "talk\na\n");
}

}  // namespace
}  // namespace aucast::app
