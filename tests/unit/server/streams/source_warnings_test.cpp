#include "server/streams/source_warnings.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

using Warnings = std::vector<std::string>;

constexpr const char* kWaved = "Beg_Stream\n6,12;100\nEnd_Stream\n";

class SourceWarningsTest : public ::testing::Test {
 protected:
  [[nodiscard]] Warnings warnings(const std::vector<std::filesystem::path>& paths) const {
    const auto sources = load_sources(paths, options_, {}, {}, nullptr, LiveKinds::Streams);
    EXPECT_TRUE(sources);
    return source_warnings(*sources, options_);
  }

  const test::TempFolder folder_;
  SourceOptions options_;
};

TEST_F(SourceWarningsTest, ATitleThatNobodyGetsIsToldWithItsLine) {
  const auto good = folder_.write("good.txt", "# title: " + std::string(120, 'a') + "\n" + kWaved);
  EXPECT_EQ(warnings({good}), Warnings());
  const auto path =
      folder_.write("a.txt", "# by hand\n# title: " + std::string(121, 'a') + "\n" + kWaved);
  EXPECT_EQ(warnings({path}), Warnings{path.string() + ":2:1: the title is left out: it has 121 "
                                                       "bytes, of at most 120"});
}

TEST_F(SourceWarningsTest, OptionsOfTablesWithoutATableAreTold) {
  const auto stream = folder_.write("a.txt", kWaved);
  const auto table = folder_.write("b.csv", sources::tables::kOpenFace1);
  EXPECT_EQ(warnings({stream}), Warnings());
  options_.signal.gain = {{std::nullopt, 1.5}};
  options_.recording.fps = 25;
  const Warnings one = warnings({stream});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_NE(one.front().find("nothing is changed by --fps, --gain: no SOURCE"), std::string::npos)
      << one.front();
  EXPECT_EQ(warnings({stream, table}), Warnings());
  EXPECT_EQ(warnings({stream, "-"}), Warnings()) << "a table may come there";
  EXPECT_EQ(warnings({"aucast://host/talk"}).size(), 1U);
}

}  // namespace
}  // namespace aucast::server
