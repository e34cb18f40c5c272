#include "server/streams/load_repertoire.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/quiet_log.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

constexpr const char* kOne = "Beg_Stream\n6,12;100\nEnd_Stream\n";

class LoadRepertoireTest : public ::testing::Test {
 protected:
  const test::QuietLog quiet_;
  const test::TempFolder folder_;
  TransmitterOptions options_;
};

TEST_F(LoadRepertoireTest, ServesTheSourcesInTheirOrder) {
  options_.sources = {folder_.write("b.txt", kOne), folder_.write("a.txt", kOne)};
  const auto loaded = load_repertoire(options_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(loaded->repertoire.size(), 2U);
  EXPECT_EQ(loaded->repertoire[0].stream.name, "b");
  EXPECT_EQ(loaded->repertoire[1].stream.name, "a");
}

TEST_F(LoadRepertoireTest, WhatIsBadIsLeftOutOnlyIfThatIsAsked) {
  options_.sources = {folder_.write("a.txt", "6,12"), folder_.write("b.txt", kOne)};
  EXPECT_FALSE(load_repertoire(options_));
  options_.skip_bad = true;
  const auto loaded = load_repertoire(options_);
  ASSERT_TRUE(loaded);
  ASSERT_EQ(loaded->repertoire.size(), 1U);
  EXPECT_EQ(loaded->repertoire.front().stream.name, "b");
}

TEST_F(LoadRepertoireTest, WhatCannotBeSentLiveIsAnErrorWhereItIsLive) {
  options_.sources = {folder_.write("a.txt", "Beg_Stream\n6;0\nEnd_Stream\n")};
  options_.loop = true;
  EXPECT_TRUE(load_repertoire(options_));
  options_.live = true;
  EXPECT_FALSE(load_repertoire(options_));
}

TEST_F(LoadRepertoireTest, SavesTheProfileThatIsAskedFor) {
  options_.sources = {folder_.write("a.csv", sources::tables::kOpenFace1)};
  options_.source.signal.save_profile = folder_.path() / "p.toml";
  ASSERT_TRUE(load_repertoire(options_));
  EXPECT_TRUE(std::filesystem::exists(options_.source.signal.save_profile));
}

TEST_F(LoadRepertoireTest, ToBeCheckedAFileIsReadAlsoWhereItWouldBeFollowed) {
  options_.sources = {folder_.write("a.txt", kOne)};
  options_.live_source.follow = true;
  const auto served = load_asked(options_, {});
  ASSERT_TRUE(served);
  EXPECT_TRUE(served->front().live);
  options_.check = true;
  const auto checked = load_asked(options_, {});
  ASSERT_TRUE(checked);
  EXPECT_FALSE(checked->front().live);
  EXPECT_TRUE(checked->front().stream);
}

TEST_F(LoadRepertoireTest, TheListOfStreamsIsOnePacket) {
  std::vector<Source> few(3);
  for (Source& source : few) source.name = "a-stream";
  few.emplace_back();  // another server will tell its name
  EXPECT_EQ(listed(few), 3U);
  std::vector<Source> many(1000);
  for (Source& source : many) source.name = std::string(64, 'a');
  EXPECT_GT(listed(many), 0U);
  EXPECT_LT(listed(many), many.size());
}

}  // namespace
}  // namespace aucast::server
