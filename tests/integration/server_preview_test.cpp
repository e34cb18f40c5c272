// --preview of the real program: what a camera sees, and others let in and out.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "common/child.h"
#include "common/preview/orders.h"
#include "common/preview/preview_reader.h"
#include "tests/integration/server_running.h"
#include "tests/support/eventually.h"
#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

/// In the place of ffmpeg: 25 grey pictures a second.
constexpr const char* kFfmpeg =
    "#!/bin/sh\nprintf 'YUV4MPEG2 W16 H12 F25:1 C444\\n'\n"
    "while printf 'FRAME\\n' && head -c 576 /dev/zero; do sleep 0.04; done\n";

class ServerPreview : public testing::Test {
 protected:
  void SetUp() override {
    const auto models = std::filesystem::path(program("data")) / "models";
    if (!std::filesystem::exists(models / "face_landmark_with_attention.tflite")) {
      GTEST_SKIP() << "NOT RUN: the models are not installed";
    }
    path_ = std::getenv("PATH");
    const auto ffmpeg = folder_.write("ffmpeg", kFfmpeg);
    std::filesystem::permissions(ffmpeg, std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  void start(const std::vector<std::string>& options = {}) {
    std::vector<std::string> command{
        program("au-transmitter"), "--preview", "--config", "/dev/null", "--port", "0"};
    command.insert(command.end(), options.begin(), options.end());
    command.emplace_back("camera");
    auto child = Child::start(command, Child::Flow::Both);
    ASSERT_TRUE(child.has_value());
    child_ = *std::move(child);
  }
  void TearDown() override {
    if (!path_.empty()) ::setenv("PATH", path_.c_str(), 1);
  }

  /// The next record of this kind; nothing at the end.
  template <typename Wanted>
  std::optional<Wanted> next() {
    std::vector<std::uint8_t> chunk(1 << 16);
    while (true) {
      auto record = reader_.next();
      if (!record) ADD_FAILURE() << record.error().message;
      if (!record) return std::nullopt;
      if (*record && std::holds_alternative<Wanted>(**record)) return std::get<Wanted>(**record);
      if (*record) continue;
      const std::size_t got = child_->read(chunk);
      if (got == 0) return std::nullopt;
      reader_.feed({reinterpret_cast<const char*>(chunk.data()), got});
    }
  }
  void order(const preview::Order& order) { ASSERT_TRUE(child_->tell(preview::order_text(order))); }

  TempFolder folder_;
  std::string path_;
  std::unique_ptr<Child> child_;
  preview::PreviewReader reader_;
};

TEST_F(ServerPreview, LetsOthersInAndShowsThemOutWhileTheCameraGoesOn) {
  start();
  const auto own = next<preview::Listening>();
  ASSERT_TRUE(own.has_value());
  const auto seen = next<preview::Seen>();
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(seen->width, 16U);
  EXPECT_EQ(seen->height, 12U);
  EXPECT_TRUE(seen->points.empty()) << "a grey picture shows nobody";
  RawClient window(own->address);
  ASSERT_TRUE(window.send("{hello v=2 window=3 token=" + own->token + "}"));
  EXPECT_TRUE(window.receive_until("}").starts_with("{hello"));

  order(preview::GoLive{"127.0.0.1", 0});
  const auto live = next<preview::Live>();
  ASSERT_TRUE(live.has_value());
  EXPECT_NE(live->address, own->address);
  RawClient viewer(live->address);
  ASSERT_TRUE(viewer.send("{hello v=2 window=3}"));
  EXPECT_TRUE(viewer.receive_until("}").starts_with("{hello"));
  auto watching = next<preview::Watching>();
  EXPECT_TRUE(watching && watching->count == 1);

  order(preview::GoPrivate{});
  EXPECT_TRUE(next<preview::Private>().has_value());
  EXPECT_TRUE(viewer.receive_all().ends_with(kEnd));
  EXPECT_FALSE(RawClient(live->address).ok());
  watching = next<preview::Watching>();
  EXPECT_TRUE(watching && watching->count == 0);
  EXPECT_TRUE(next<preview::Seen>().has_value());
  EXPECT_FALSE(window.ended());

  // And again, at once, where it was before.
  const std::string port = live->address.substr(live->address.rfind(':') + 1);
  order(preview::GoLive{"127.0.0.1", static_cast<std::uint16_t>(std::stoi(port))});
  EXPECT_TRUE(next<preview::Live>().has_value());
  EXPECT_TRUE(RawClient(live->address).ok());

  order(preview::GoLive{"192.0.2.1", 4650});
  EXPECT_TRUE(next<preview::Private>().has_value()) << "nobody is let in any more";
  auto refused = next<preview::Refused>();
  ASSERT_TRUE(refused.has_value());
  EXPECT_NE(refused->sentence.find("192.0.2.1"), std::string::npos);
  order(preview::GoLive{"a.name.example", 4650});
  refused = next<preview::Refused>();
  ASSERT_TRUE(refused.has_value());
  EXPECT_NE(refused->sentence.find("no address in numbers"), std::string::npos);
}

TEST_F(ServerPreview, NobodyElseOfThisHostWatchesBeforeOthersAreLetIn) {
  start();
  const auto own = next<preview::Listening>();
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->token.size(), 32U);
  for (const std::string hello :
       {"{hello v=2 window=3}", "{hello v=2 window=3 token=sesame}", "{streams v=2}"}) {
    RawClient stranger(own->address);
    ASSERT_TRUE(stranger.send(hello));
    EXPECT_TRUE(stranger.receive_until("}").starts_with("{error 401")) << hello;
  }
  reader_ = {};
  start();
  const auto next_time = next<preview::Listening>();
  ASSERT_TRUE(next_time.has_value());
  EXPECT_NE(next_time->token, own->token);
}

TEST_F(ServerPreview, OnlyGuestsMustShowTheTokenOfTheFile) {
  const auto token = folder_.write("token", "sesame\n");
  std::filesystem::permissions(token, std::filesystem::perms::owner_read);
  start({"--token-file", token.string()});
  const auto own = next<preview::Listening>();
  ASSERT_TRUE(own.has_value());
  RawClient window(own->address);
  ASSERT_TRUE(window.send("{hello v=2 window=3 token=" + own->token + "}"));
  EXPECT_TRUE(window.receive_until("}").starts_with("{hello"));
  order(preview::GoLive{"127.0.0.1", 0});
  const auto live = next<preview::Live>();
  ASSERT_TRUE(live.has_value());
  RawClient stranger(live->address);
  ASSERT_TRUE(stranger.send("{hello v=2 window=3}"));
  EXPECT_TRUE(stranger.receive_until("}").starts_with("{error 401"));
  RawClient guest(live->address);
  ASSERT_TRUE(guest.send("{hello v=2 window=3 token=sesame}"));
  EXPECT_TRUE(guest.receive_until("}").starts_with("{hello"));
}

TEST_F(ServerPreview, EndsWithWhoStartedIt) {
  start();
  ASSERT_TRUE(next<preview::Seen>().has_value());
  child_->end_input();
  EXPECT_FALSE(next<preview::Private>().has_value()) << "it ends";
  EXPECT_EQ(child_->wait(), 0);
}

TEST_F(ServerPreview, EndsInOrderWhileTheCameraHasShownNothing) {
  const auto begun = folder_.path() / "begun";
  folder_.write("ffmpeg", "#!/bin/sh\necho > " + begun.string() + "\nexec sleep 1000\n");
  const auto awaited = [&begun] { return std::filesystem::exists(begun); };
  start();
  ASSERT_TRUE(eventually(awaited));
  child_->end_input();
  EXPECT_EQ(child_->wait(), 0) << "who started it has gone";

  std::filesystem::remove(begun);
  Process process({program("au-transmitter"), "--config", "/dev/null", "--port", "0", "camera"});
  ASSERT_TRUE(eventually(awaited));
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(std::chrono::seconds(5)), 0) << process.err();
}

TEST(ServerPreviewOptions, OnlyACameraIsShown) {
  const auto ended = run({program("au-transmitter"), "--preview", stream_file("talk.txt")});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(ended.err.find("--preview shows what a camera sees"), std::string::npos);
}

}  // namespace
}  // namespace aucast::test
