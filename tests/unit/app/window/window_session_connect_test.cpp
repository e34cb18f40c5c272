#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "client/app/window/window_settings.h"
#include "client/gui/texts.h"
#include "tests/unit/app/window/window_session_fixture.h"

namespace aucast::app {
namespace {

using gui::Activity;

/// A session that has not played anything.
class ConnectTest : public SessionOnDefaultFace {
 protected:
  void SetUp() override { session_.emplace(*assets_, options_, nullptr, stats_); }
  void ask(const gui::GuiCommand& command) { session_->apply(command, clock_.now()); }
};

TEST_F(ConnectTest, ConnectNeedsAFormThatIsRight) {
  ask(gui::Connect{{"", 4650, 100, 30, 40, 0}});
  EXPECT_EQ(model().remote.activity, Activity::Idle);
}

TEST_F(ConnectTest, AnAddressThatDidNotAnswerIsNotKept) {
  gui::KeptSettings settings;
  settings.remote.address = "lecture.example.org";
  settings.remote.token_file = "secret";
  session_->begin_with(settings, "", clock_.now());
  gui::RemoteSettings mistyped = settings.remote;
  mistyped.address = "127.0.0.1";
  mistyped.port = 1;
  mistyped.token_file.clear();
  mistyped.buffer = 50;
  ask(gui::Connect{mistyped});
  EXPECT_EQ(model().remote_settings, mistyped) << "it can be corrected";
  settings.remote.buffer = 50;
  EXPECT_EQ(session_->kept().remote, settings.remote);
}

TEST_F(ConnectTest, WhyThereIsNoConnectionIsSaidInTheLanguageInUse) {
  auto french = gui::load_language(assets_->data_folder / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  gui::use_language(*std::move(french));
  gui::RemoteSettings nobody;
  nobody.address = "127.0.0.1";
  nobody.port = 1;
  ask(gui::Connect{nobody});
  std::string detail;
  for (int i = 0; i < 4000 && detail.empty(); ++i) {
    session_->advance(clock_.now());
    detail = model().remote.detail;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  gui::use_english();
  EXPECT_NE(detail.find("127.0.0.1:1"), std::string::npos) << detail;
  EXPECT_NE(detail.find("connexion refusée"), std::string::npos) << detail;
  EXPECT_EQ(detail.find("running"), std::string::npos) << detail;
}

TEST_F(ConnectTest, TheOtherHostsOfAnAddressAreTriedTooWhoeverNamedThem) {
  options_.playback.endpoint = "one.example";
  options_.playback.others = {{"other.example", 4650}};
  Notices notices;
  const std::vector<float> shown(assets_->face.channels.size());
  const pipeline::AuMapping mapping = au_mapping(*assets_, options_.face.mixer);
  const PlaybackSession playback(mapping, options_, stats_, notices, shown);
  gui::RemoteSettings form = WindowSettings(options_, {}).in_force().remote;
  const auto same = playback.server_of(form);
  ASSERT_TRUE(same) << same.error().message;
  EXPECT_EQ(same->others, options_.playback.others);
  EXPECT_TRUE(same->reconnect) << "else the other is never tried";
  ASSERT_EQ(gui::take_address("aucast://third.example,fourth.example:7/talk", form), std::nullopt);
  const auto named = playback.server_of(form);
  ASSERT_TRUE(named) << named.error().message;
  EXPECT_EQ(named->others, (std::vector<protocol::Endpoint>{{"fourth.example", 7}}));
  EXPECT_TRUE(named->reconnect);
  ASSERT_EQ(gui::take_address("third.example", form), std::nullopt);
  const auto third = playback.server_of(form);
  ASSERT_TRUE(third) << third.error().message;
  EXPECT_TRUE(third->others.empty());
  EXPECT_FALSE(third->reconnect);
}

TEST_F(ConnectTest, ATokenFileThatIsNotThereIsSaid) {
  gui::RemoteSettings settings;
  settings.token_file = "/no/such/token";
  ask(gui::Connect{settings});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("/no/such/token"), std::string::npos);
  EXPECT_EQ(model().remote.activity, Activity::Idle);
}

}  // namespace
}  // namespace aucast::app
