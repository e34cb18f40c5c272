#include "client/app/window/settings/settings_session.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gui/texts/texts.h"
#include "tests/support/home_variable.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

/// With a data folder of its own, which has one set of rules and no language.
class SettingsSessionTest : public testing::Test {
 protected:
  void SetUp() override { assets_.data_folder = folder_.path(); }
  void TearDown() override { gui::use_english(); }
  void ask(const gui::SettingsCommand& command) { session().apply(command, {}); }
  SettingsSession& session() {
    if (!session_) {
      session_.emplace(assets_, options_, mapping_, notices_,
                       SettingsSession::Events{[this] { ++animations_; }, [this] { ++languages_; },
                                               [this](const std::filesystem::path& folder) {
                                                 folders_.push_back(folder.string());
                                               }});
    }
    return *session_;
  }

  test::TempFolder folder_;
  Assets assets_;
  PlayerOptions options_;
  pipeline::AuMapping mapping_{assets_.face, {}, {}};
  Notices notices_;
  int animations_ = 0;
  int languages_ = 0;
  std::vector<std::string> folders_;
  std::optional<SettingsSession> session_;
};

TEST_F(SettingsSessionTest, BeginsAsTheCommandLineSays) {
  options_.face.mixer = face::Mixer::Average;
  options_.playback.blink.emplace();
  options_.output.layers.muscles = true;
  EXPECT_EQ(session().animation().mixer, face::Mixer::Average);
  EXPECT_TRUE(session().rendering().blinking);
  EXPECT_TRUE(session().rendering().layers.muscles);
}

TEST_F(SettingsSessionTest, AnotherMixerChangesTheMapping) {
  gui::AnimationSettings settings = session().animation();
  settings.mixer = face::Mixer::Average;
  ask(gui::ChangeAnimation{settings});
  EXPECT_EQ(mapping_.mixer, face::Mixer::Average);
  EXPECT_EQ(animations_, 1);
}

TEST_F(SettingsSessionTest, RulesThatCannotBeReadChangeNothing) {
  gui::AnimationSettings settings = session().animation();
  const gui::AnimationSettings before = settings;
  settings.rules = "/no/such/rules.toml";
  settings.mixer = face::Mixer::Average;
  ask(gui::ChangeAnimation{settings});
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_NE(notices_.view().text.find("/no/such/rules.toml"), std::string::npos);
  EXPECT_EQ(session().animation(), before);
  EXPECT_EQ(mapping_.mixer, face::Mixer::Maximum);
  EXPECT_EQ(animations_, 0);
}

TEST_F(SettingsSessionTest, OnlyAnotherFolderMovesPictures) {
  gui::PictureSettings settings = session().pictures();
  settings.pattern = "smile";
  ask(gui::ChangePictures{settings});
  EXPECT_TRUE(folders_.empty());
  settings.folder = "/stimuli";
  ask(gui::ChangePictures{settings});
  ask(gui::ChangePictures{settings});
  EXPECT_EQ(folders_, std::vector<std::string>{"/stimuli"});
  EXPECT_EQ(session().pictures(), settings);
}

TEST_F(SettingsSessionTest, ALanguageThatIsChosenAndNotThereIsSaid) {
  ask(gui::ChangeDisplay{gui::DisplaySettings{.language = "tlh"}});
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_EQ(session().display().language, "en");
  EXPECT_EQ(session().display().settings.language, "tlh") << "it may be there at the next start";
  EXPECT_EQ(languages_, 0);
}

TEST_F(SettingsSessionTest, NobodyBeginsWithAnEmptyView) {
  gui::KeptSettings kept;
  for (const view::LayerName& layer : view::kLayerNames) {
    kept.rendering.layers.*layer.member = false;
  }
  session().begin_with(kept, {});
  EXPECT_EQ(session().rendering().layers, view::Layers());
}

TEST_F(SettingsSessionTest, WhatIsKeptBeginsTheSameWay) {
  gui::KeptSettings kept;
  kept.rendering.blinking = true;
  kept.pictures.folder = "/stimuli";
  kept.pictures.pattern = "smile";
  kept.display.language = "en";
  session().begin_with(kept, {});
  gui::KeptSettings again;
  session().keep(again);
  EXPECT_EQ(again.rendering, kept.rendering);
  EXPECT_EQ(again.pictures, kept.pictures);
  EXPECT_EQ(again.display, kept.display);
  EXPECT_EQ(folders_, std::vector<std::string>{"/stimuli"});
}

TEST_F(SettingsSessionTest, AHalfTypedNameIsNotKept) {
  gui::PictureSettings settings;
  settings.pattern = "{expr";
  ask(gui::ChangePictures{settings});
  gui::KeptSettings kept;
  session().keep(kept);
  EXPECT_EQ(kept.pictures.pattern, gui::PictureSettings().pattern);
  EXPECT_EQ(session().pictures().pattern, "{expr");
}

TEST_F(SettingsSessionTest, PicturesAreDrawnAsTheWindowShowsThem) {
  gui::RenderingSettings rendering;
  rendering.ground = gui::Ground::None;
  rendering.layers.muscles = true;
  ask(gui::ChangeRendering{rendering});
  gui::AnimationSettings animation = session().animation();
  animation.mixer = face::Mixer::Average;
  ask(gui::ChangeAnimation{animation});
  const PlayerOptions applied = session().applied({});
  EXPECT_TRUE(applied.output.transparent);
  EXPECT_TRUE(applied.output.layers.muscles);
  EXPECT_EQ(applied.face.mixer, face::Mixer::Average);
}

TEST_F(SettingsSessionTest, PicturesMayGoToTheHomeFolder) {
  const test::HomeVariable home;
  gui::PictureSettings settings;
  settings.folder = "~/stimuli";
  ask(gui::ChangePictures{settings});
  EXPECT_EQ(session_->pictures().folder, home.in("stimuli"));
  EXPECT_EQ(folders_, std::vector<std::string>{home.in("stimuli")});
  settings.folder = "./~";
  ask(gui::ChangePictures{settings});
  EXPECT_EQ(session_->pictures().folder, "./~");
}

}  // namespace
}  // namespace aucast::app
