// The mirror with scripts of our own in the place of au-transmitter.
#include "client/mirror/mirror.h"

#include <csignal>

#include <cstdlib>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "client/mirror/host_addresses.h"
#include "common/preview/preview_writer.h"
#include "tests/support/eventually.h"
#include "tests/support/temp_folder.h"

namespace aucast::mirror {
namespace {

preview::Seen one_pixel(std::uint8_t grey) {
  return {1, 1, {grey, grey, grey}, {{0, 1}}, {{12, Side::Both, 40}}};
}

/// A folder with a program that does what a script says; the file `record` is a picture.
class MirrorTest : public testing::Test {
 protected:
  void begin(const std::string& script) {
    folder_.write("record", preview::seen_record(one_pixel(9)));
    const auto program = folder_.write(
        "au-transmitter", "#!/bin/sh\ncd '" + folder_.path().string() + "'\n" + script);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    auto started = Mirror::start({program, "camera:film.mp4", guests_token_});
    ASSERT_TRUE(started.has_value()) << started.error().message;
    mirror_ = std::move(*started);
  }
  bool becomes(const std::function<bool(const MirrorState&)>& wanted) {
    return test::eventually([&] { return wanted(mirror_->state()); });
  }
  /// The process that the script wrote into `pid` has gone.
  [[nodiscard]] bool is_gone() const {
    return ::kill(std::atoi(folder_.read("pid").c_str()), 0) != 0;
  }

  test::TempFolder folder_;
  std::string guests_token_;
  std::unique_ptr<Mirror> mirror_;
};

constexpr const char* kObey =
    "echo 'listening on 127.0.0.1:4711 0a1b'; cat record\n"
    "while read order port bind; do\n"
    "  case $order in live) echo live $bind:$port; echo watching 2;; *) echo private;; esac\n"
    "done\n";

TEST_F(MirrorTest, TellsWhatItsCameraSeesAndGoesLive) {
  begin(std::string("echo \"$@\" > arguments\n") + kObey);
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.seen != nullptr; }));
  MirrorState state = mirror_->state();
  EXPECT_EQ(*state.seen, one_pixel(9));
  EXPECT_EQ(state.own.address, "127.0.0.1:4711");
  EXPECT_EQ(state.own.token, "0a1b");
  EXPECT_EQ(state.live, "");
  const std::string arguments = folder_.read("arguments");
  EXPECT_NE(arguments.find("--preview"), std::string::npos);
  EXPECT_NE(arguments.find("--bind 127.0.0.1 --port 0"), std::string::npos);
  EXPECT_NE(arguments.find(" camera:film.mp4\n"), std::string::npos);
  mirror_->order(preview::GoLive{"0.0.0.0", 4650});
  EXPECT_TRUE(becomes([](const MirrorState& now) { return now.watching == 2; }));
  EXPECT_EQ(mirror_->state().live, "0.0.0.0:4650");
  mirror_->order(preview::GoPrivate{});
  EXPECT_TRUE(becomes([](const MirrorState& now) { return now.live.empty(); }));
  mirror_->end();
  EXPECT_TRUE(becomes([](const MirrorState& now) { return now.over; }));
  EXPECT_EQ(mirror_->state().ended.kind, Trouble::Kind::None) << "it was asked to";
}

TEST_F(MirrorTest, HandsOnWhatGuestsAreAskedFor) {
  guests_token_ = "/a token";
  begin(std::string("for word; do echo \"<$word>\" >> arguments; done\n") + kObey);
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.seen != nullptr; }));
  const std::string arguments = folder_.read("arguments");
  EXPECT_NE(arguments.find("<--token-file>\n</a token>\n"), std::string::npos) << arguments;
  EXPECT_EQ(arguments.find("--tls-cert"), std::string::npos);
}

TEST_F(MirrorTest, EndsWithItsOwner) {
  begin(std::string("echo $$ > pid\n") + kObey);
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.seen != nullptr; }));
  mirror_.reset();
  EXPECT_TRUE(is_gone());
}

TEST_F(MirrorTest, KillsAChildThatDoesNotEnd) {
  begin("echo $$ > pid; cat record; exec sleep 1000");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.seen != nullptr; }));
  mirror_.reset();
  EXPECT_TRUE(is_gone());
}

TEST_F(MirrorTest, SurvivesItsChildAndSaysItsLastLine) {
  begin(
      "cat record; echo first >&2\n"
      "echo '2026-01-02T03:04:05Z warning au-transmitter: the camera has gone' >&2; exit 1");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.over; }));
  EXPECT_EQ(mirror_->state().ended.said, "the camera has gone");
  mirror_->order(preview::GoLive{"0.0.0.0", 4650});
  EXPECT_EQ(mirror_->state().live, "");
}

TEST_F(MirrorTest, SaysThatAChildEndedWithoutAWord) {
  begin("exit 3");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.over; }));
  EXPECT_EQ(mirror_->state().ended.kind, Trouble::Kind::Ended);
}

TEST_F(MirrorTest, SaysThatAChildWasKilledByAnother) {
  begin("cat record; echo 'all is well' >&2; kill -KILL $$");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.over; }));
  EXPECT_EQ(mirror_->state().ended.kind, Trouble::Kind::Signalled);
  EXPECT_EQ(mirror_->state().ended.signal, SIGKILL);
}

TEST_F(MirrorTest, KillsAChildThatStaysWithoutOutputAndDoesNotSaySo) {
  begin("echo $$ > pid; cat record; echo 'the camera has gone' >&2; exec sleep 1000 <&- >&- 2>&-");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.over; }));
  EXPECT_EQ(mirror_->state().ended.said, "the camera has gone");
  EXPECT_TRUE(is_gone());
}

TEST_F(MirrorTest, TellsTheEndOfAFilmFromAFailure) {
  begin("cat record; echo 'the camera gives no more pictures' >&2");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.over; }));
  EXPECT_EQ(mirror_->state().ended.kind, Trouble::Kind::NoPictures);
}

TEST_F(MirrorTest, EndsAChildThatTalksNonsense) {
  begin("echo $$ > pid; echo 'seen 99999 1 0 0'; exec sleep 1000");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.over; }));
  EXPECT_NE(mirror_->state().ended.said.find("no preview"), std::string::npos);
  EXPECT_TRUE(is_gone());
}

TEST_F(MirrorTest, TellsWhatWasRefused) {
  begin(
      "cat record; echo live 127.0.0.1:1; read order; echo refused this port is taken; read order");
  ASSERT_TRUE(becomes([](const MirrorState& state) { return state.seen != nullptr; }));
  mirror_->order(preview::GoLive{"0.0.0.0", 1});
  ASSERT_TRUE(becomes([](const MirrorState& state) { return !state.refused.said.empty(); }));
  EXPECT_EQ(mirror_->state().refused.said, "this port is taken");
  EXPECT_EQ(mirror_->state().live, "127.0.0.1:1") << "only 'private' says that it is not live";
}

TEST(Mirror, WithoutAuTransmitterSaysWhereItBelongs) {
  const auto started = Mirror::start({"aucast-no-such-program", "camera"});
  ASSERT_FALSE(started.has_value());
  EXPECT_NE(started.error().message.find("belongs beside face-player"), std::string::npos);
}

TEST(Mirror, AddressesOfThisHostAreNotItsLoopback) {
  for (const std::string& address : host_addresses()) EXPECT_FALSE(address.starts_with("127."));
}

}  // namespace
}  // namespace aucast::mirror
