#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "client/gui/storage/language_file.h"
#include "client/gui/texts/texts.h"
#include "client/playback/source_playback.h"
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
  EXPECT_EQ(model().playing.activity, Activity::Idle);
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

TEST_F(ConnectTest, TheVolumeIsKeptWithoutAWord) {
  gui::KeptSettings settings;
  settings.volume = 96;
  session_->begin_with(settings, "", clock_.now());
  EXPECT_EQ(model().sound.volume, 96);
  EXPECT_TRUE(model().notice.text.empty());
  session_->sound().change_volume(-2, clock_.now());
  EXPECT_EQ(session_->kept().volume, 94);
}

TEST_F(ConnectTest, WhyThereIsNoConnectionIsSaidInTheLanguageInUse) {
  auto french = gui::load_language(assets_->data_folder / "languages" / "fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  gui::use_language(std::move(french->language));
  auto source = std::make_unique<playback::test::ScriptedSource>();
  source->now.end = playback::EndReason::Unreachable;
  // As net/server_connection and link/dialler say it.
  source->now.detail =
      "cannot reach 127.0.0.1:1: Connection refused; is au-transmitter running there, on an "
      "address that can be reached from here?";
  session_.emplace(*assets_, options_,
                   std::make_unique<playback::SourcePlayback>(std::move(source),
                                                              playback::SourcePlayback::Options{}),
                   stats_);
  go_on(Milliseconds(0));
  const std::string detail = model().playing.detail;
  gui::use_english();
  EXPECT_NE(detail.find("127.0.0.1:1"), std::string::npos) << detail;
  EXPECT_NE(detail.find("connexion refusée"), std::string::npos) << detail;
  EXPECT_EQ(detail.find("running"), std::string::npos) << detail;
}

TEST_F(ConnectTest, ATokenFileThatIsNotThereIsSaid) {
  gui::RemoteSettings settings;
  settings.token_file = "/no/such/token";
  ask(gui::Connect{settings});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("/no/such/token"), std::string::npos);
  EXPECT_EQ(model().playing.activity, Activity::Idle);
  settings = {"127.0.0.1", 1};
  ask(gui::Connect{settings});
  EXPECT_TRUE(model().notice.text.empty()) << "it was about another server";
}

TEST_F(ConnectTest, TheTitleOfTheWindowNamesServerAndStream) {
  gui::RemoteSettings settings{"127.0.0.1", 1};
  settings.stream = "lecture";
  ask(gui::Connect{settings});
  EXPECT_TRUE(session_->playback().title().starts_with("127.0.0.1:1/lecture - AUcast - "))
      << session_->playback().title();
}

}  // namespace
}  // namespace aucast::app
