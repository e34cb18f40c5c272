#include "server/streams/measured_profile.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

class MeasuredProfileTest : public ::testing::Test {
 protected:
  MeasuredProfileTest() {
    options_.save_profile = folder_.path() / "profile.toml";
    options_.neutral_seconds = 1;
  }
  /// A recording in which the face was measured while it did not rest: AU 12 at 20 %.
  [[nodiscard]] static Source recording() {
    Source source;
    source.found.emplace();
    source.found->neutral.emplace();
    source.found->neutral->seconds = 1;
    return source;
  }
  [[nodiscard]] bool written() const { return std::filesystem::exists(options_.save_profile); }

  const test::TempFolder folder_;
  SignalOptions options_;
};

TEST_F(MeasuredProfileTest, WithoutNeutralItNeedsNoSource) {
  options_.neutral_seconds.reset();
  EXPECT_TRUE(save_measured_profile(options_, {}, {Source(), recording(), recording()}));
  EXPECT_TRUE(written());
}

TEST_F(MeasuredProfileTest, NothingIsWrittenUnlessItIsAskedFor) {
  options_.save_profile.clear();
  EXPECT_TRUE(save_measured_profile(options_, {}, {recording(), recording()}));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(MeasuredProfileTest, OnlyOneSourceCanBeMeasured) {
  const std::vector<Source> none{Source()};
  const std::vector<Source> two{recording(), Source(), recording()};
  for (const auto& [sources, count] : {std::pair(none, "0"), std::pair(two, "2")}) {
    const auto refused = save_measured_profile(options_, {}, sources);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
    EXPECT_NE(refused.error().message.find(std::string("there are ") + count), std::string::npos)
        << refused.error().message;
    EXPECT_FALSE(written());
  }
}

TEST_F(MeasuredProfileTest, ALiveSourceIsMeasuredLater) {
  Source live;
  live.live = true;
  EXPECT_TRUE(save_measured_profile(options_, {}, {Source(), live}));
  EXPECT_FALSE(written());
  EXPECT_FALSE(save_measured_profile(options_, {}, {live, recording()}));
}

}  // namespace
}  // namespace aucast::server
