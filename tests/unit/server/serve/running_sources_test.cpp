// Which sources run, and what is wrong with them; what becomes of their bytes is tested with
// LiveSource and Upstream.
#include "server/serve/running_sources.h"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

class RunningSourcesTest : public ::testing::Test {
 protected:
  RunningSources& sources() {
    if (!sources_) {
      sources_.emplace(io_, options_, "id", RelayedStream::TakeName(),
                       RunningSources::Events{[this] { ++moments_; }, [this] { ++faces_; }});
    }
    return *sources_;
  }
  [[nodiscard]] std::filesystem::path fifo(const std::string& name) const {
    const auto path = folder_.path() / name;
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    return path;
  }
  /// Which kind of error open() gives; nothing: none.
  std::optional<ErrorKind> refused() {
    const auto opened = sources().open();
    return opened ? std::nullopt : std::optional(opened.error().kind);
  }

  const test::QuietLog quiet_;
  const test::TempFolder folder_;
  asio::io_context io_;
  TransmitterOptions options_;
  int moments_ = 0;
  int faces_ = 0;
  std::optional<RunningSources> sources_;
};

TEST_F(RunningSourcesTest, RecordedSourcesAreNone) {
  options_.sources = {folder_.write("a.txt", "Beg_Stream\n1\nEnd_Stream\n")};
  EXPECT_EQ(refused(), std::nullopt);
  EXPECT_TRUE(sources().over());
  EXPECT_TRUE(sources().streams().empty());
  EXPECT_TRUE(sources().finish());
}

TEST_F(RunningSourcesTest, FilesRunWhenTheyAreFollowedAndPipesAlways) {
  const auto growing = folder_.write("growing.txt", "12:10;100\n");
  options_.sources = {growing, fifo("pipe")};
  options_.live_source.follow = true;
  EXPECT_EQ(refused(), std::nullopt);
  EXPECT_FALSE(sources().streams().empty());
  EXPECT_FALSE(sources().over());
  const auto streams = sources().streams();
  ASSERT_EQ(streams.size(), 2U);
  EXPECT_EQ(streams[0].name, "growing");
  EXPECT_EQ(streams[1].name, "pipe");
  const auto sends = [&](const char* packet) {
    return test::run_until(io_, [&] {
      const protocol::LiveMoment* moment = streams[0].live()->newest();
      return moment != nullptr && moment->full == packet;
    });
  };
  EXPECT_TRUE(sends("{12:10;100}"));
  std::ofstream(growing, std::ios::app) << "12:20;100\n";
  EXPECT_TRUE(sends("{12:20;100}"));
  EXPECT_GE(moments_, 2);
  sources().stop();
}

TEST_F(RunningSourcesTest, AProfileThatCannotBeReadIsAnError) {
  options_.sources = {fifo("pipe")};
  options_.source.signal.profile = folder_.path() / "p.toml";
  EXPECT_EQ(refused(), ErrorKind::Unreadable);
  EXPECT_TRUE(sources().streams().empty());
  folder_.write("p.toml", "");
  EXPECT_EQ(refused(), std::nullopt);
  EXPECT_EQ(sources().streams().size(), 1U);
}

TEST_F(RunningSourcesTest, TheMeasuredNeutralFaceIsWrittenByTheEnd) {
  using sources::tables::openface2_row;
  std::string table = sources::tables::kOpenFace2Header;
  for (int i = 0; i < 4; ++i) {
    table += openface2_row(i, "0." + std::to_string(i), "0.5,0,0,0,0,0,0");
  }
  const auto face = fifo("face");
  options_.sources = {face};
  options_.source.signal.save_profile = folder_.path() / "p.toml";
  options_.source.signal.neutral_seconds = 0.2;
  EXPECT_EQ(refused(), std::nullopt);
  std::ofstream(face) << table << std::flush;
  EXPECT_TRUE(test::run_until(io_, [this] { return moments_ > 3; }));
  sources().stop();
  EXPECT_TRUE(sources().finish());
  EXPECT_NE(folder_.read("p.toml").find("\n1 = 10\n"), std::string::npos) << folder_.read("p.toml");
}

TEST_F(RunningSourcesTest, AVoiceMustLeaveSomethingForTheFace) {
  options_.sources = {fifo("face")};
  options_.voice.file = fifo("voice");
  options_.max_kbits = 1;
  EXPECT_EQ(refused(), ErrorKind::Usage);
  sources_.reset();
  options_.max_kbits = 1000;
  EXPECT_EQ(refused(), std::nullopt);
  sources_.reset();
  options_.max_kbits = 1;
  options_.voice.none = true;
  EXPECT_EQ(refused(), std::nullopt);
}

TEST_F(RunningSourcesTest, ATokenGoesToNoServerInTheOpen) {
  options_.sources = {"aucast://campus.invalid/talk"};
  options_.upstream.token = folder_.write("token", "0123456789abcdef\n");
  EXPECT_EQ(refused(), ErrorKind::Usage);
}

TEST_F(RunningSourcesTest, AnotherServersStreamIsThereBeforeItHasSaidAnything) {
  options_.sources = {"aucast://127.0.0.1:1/talk"};
  EXPECT_EQ(refused(), std::nullopt);
  EXPECT_FALSE(sources().streams().empty());
  EXPECT_FALSE(sources().over());
  ASSERT_EQ(sources().streams().size(), 1U);
  EXPECT_EQ(sources().streams().front().known_name(), "talk");
  Status status;
  sources().describe(status);
  EXPECT_EQ(status.upstreams.size(), 1U);
  sources().stop();
}

}  // namespace
}  // namespace aucast::server
