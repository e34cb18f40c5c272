#include "client/app/window/recording/onset_log.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

TEST(OnsetLog, HasARowForEachPictureOnceItIsFinished) {
  const test::TempFolder folder;
  const auto file = folder.path() / "onsets.csv";
  OnsetLog log;
  ASSERT_TRUE(log.begin(file));
  AuFrame smile;
  set_intensity(smile, 6, Side::Both, 0.4F);
  set_intensity(smile, 12, Side::Left, 1);
  log.add(Instant(std::chrono::microseconds(1'500'000)), {1, 0, smile});
  log.add(Instant(std::chrono::microseconds(1'516'667)), {2, 1, AuFrame{}});
  log.add(Instant(std::chrono::microseconds(20'000'000)), {0, 0, std::nullopt});
  EXPECT_FALSE(std::filesystem::exists(file));
  ASSERT_TRUE(log.end());
  EXPECT_EQ(folder.read("onsets.csv"),
            "monotonic_s,keyframe,aus,reached\n"
            "1.500000,1,\"6:40,L12\",\n"
            "1.516667,2,\"0\",1\n"
            "20.000000,0,\"\",\n");
}

TEST(OnsetLog, NamesAKeyframeInTheFirstPictureThatHasReachedIt) {
  const test::TempFolder folder;
  OnsetLog log;
  ASSERT_TRUE(log.begin(folder.path() / "onsets.csv"));
  const auto add = [&log](std::uint64_t keyframe, std::uint64_t reached) {
    log.add(Instant{}, {keyframe, reached, AuFrame{}});
  };
  add(1, 0);
  add(2, 1);
  add(2, 1);
  add(5, 4);  // two of 0 ms between
  add(0, 0);  // the editor's face, and back
  add(5, 4);
  add(5, 5);
  add(1, 0);  // again from the beginning
  add(1, 1);
  ASSERT_TRUE(log.end());
  std::istringstream table(folder.read("onsets.csv"));
  std::vector<std::string> reached;
  for (std::string row; std::getline(table, row);)
    reached.push_back(row.substr(row.rfind(',') + 1));
  EXPECT_EQ(reached,
            (std::vector<std::string>{"reached", "", "1", "", "2-4", "", "", "5", "", "1"}));
}

TEST(OnsetLog, OfARunThatFailsIsKeptAsFarAsItCame) {
  const test::TempFolder folder;
  {
    OnsetLog log;
    ASSERT_TRUE(log.begin(folder.path() / "onsets.csv"));
    log.add(Instant(std::chrono::microseconds(1'500'000)), {1, 0, AuFrame{}});
  }
  EXPECT_EQ(folder.read("onsets.csv"), "monotonic_s,keyframe,aus,reached\n1.500000,1,\"0\",\n");
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "and nothing lies beside it";
}

TEST(OnsetLog, SaysAtTheStartThatItsPlaceCannotBeWritten) {
  OnsetLog log;
  const auto begun = log.begin("/nowhere/at/all.csv");
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().kind, ErrorKind::Failed);
}

TEST(OnsetLog, WritesOneTableAfterTheOther) {
  const test::TempFolder folder;
  OnsetLog onsets;
  EXPECT_TRUE(onsets.end()) << "there is none";
  onsets.add(Instant(std::chrono::seconds(1)), {1, 0, AuFrame{}});
  ASSERT_TRUE(onsets.begin(folder.path() / "one.csv"));
  EXPECT_EQ(onsets.file(), folder.path() / "one.csv");
  onsets.add(Instant(std::chrono::seconds(2)), {1, 0, AuFrame{}});
  EXPECT_FALSE(onsets.begin("/nowhere/at/all.csv"));
  EXPECT_EQ(onsets.file(), "") << "the one before is finished";
  EXPECT_EQ(folder.read("one.csv"), "monotonic_s,keyframe,aus,reached\n2.000000,1,\"0\",\n");
  ASSERT_TRUE(onsets.begin(folder.path() / "two.csv"));
  ASSERT_TRUE(onsets.end());
  EXPECT_EQ(folder.read("two.csv"), "monotonic_s,keyframe,aus,reached\n");
}

}  // namespace
}  // namespace aucast::app
