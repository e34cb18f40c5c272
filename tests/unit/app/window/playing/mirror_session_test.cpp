#include "client/app/window/playing/mirror_session.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/gui/texts/texts.h"
#include "tests/support/home_variable.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

using mirror::Trouble;
using Phase = gui::MirrorView::Phase;

/// What a camera of the tests was asked for, and what it tells.
struct CameraScript {
  mirror::MirrorState state;
  std::vector<preview::Order> orders;
  bool asked_to_end = false;
  bool there = false;
};

class ScriptedCamera final : public mirror::OwnCamera {
 public:
  explicit ScriptedCamera(CameraScript& script) : script_(script) { script_.there = true; }
  ~ScriptedCamera() override { script_.there = false; }
  void order(const preview::Order& order) override { script_.orders.push_back(order); }
  void end() override { script_.asked_to_end = true; }
  [[nodiscard]] mirror::MirrorState state() const override { return script_.state; }

 private:
  CameraScript& script_;
};

class MirrorSessionTest : public testing::Test {
 protected:
  Result<std::unique_ptr<mirror::OwnCamera>> start(const mirror::MirrorOptions& options) {
    opened_.push_back(options.source);
    if (refused_) return *refused_;
    script_ = {};
    return std::unique_ptr<mirror::OwnCamera>(std::make_unique<ScriptedCamera>(script_));
  }
  void see() {
    script_.state.seen = std::make_shared<const preview::Seen>();
    script_.state.own = {"127.0.0.1:4711", "0a1b"};
  }
  void lose(Trouble::Kind kind) {
    script_.state.over = true;
    script_.state.ended = {kind};
  }

  test::TempFolder folder_;
  const std::string film_ = folder_.write("talk.mp4", "").string();
  CameraScript script_;
  std::vector<std::string> opened_;
  std::optional<Error> refused_;
  MirrorSession session_{{},
                         [this](const mirror::MirrorOptions& options) { return start(options); }};
};

TEST_F(MirrorSessionTest, ItsStreamIsToldOnceAsSoonAsItIsThere) {
  EXPECT_EQ(session_.advance(), std::nullopt);
  session_.apply(gui::StartMirror{"camera"});
  EXPECT_TRUE(session_.running());
  EXPECT_EQ(session_.view().phase, Phase::Starting);
  EXPECT_EQ(session_.advance(), std::nullopt);
  see();
  EXPECT_EQ(session_.advance(), (MirrorSession::OwnServer{{"127.0.0.1", 4711}, "0a1b"}));
  EXPECT_EQ(session_.view().phase, Phase::Private);
  EXPECT_NE(session_.view().seen, nullptr);
  EXPECT_EQ(session_.advance(), std::nullopt) << "it plays already";
}

TEST_F(MirrorSessionTest, ASecondStartOpensNoSecondCamera) {
  session_.apply(gui::StartMirror{"camera"});
  session_.apply(gui::StartMirror{"camera:other"});
  EXPECT_EQ(opened_, std::vector<std::string>{"camera"});
}

TEST_F(MirrorSessionTest, AFileThatIsNoFilmIsNotTakenForACamera) {
  const test::TempFolder folder;
  const std::string picture = folder.write("me.JPG", "").string();
  const std::string film = folder.write("me.mp4", "").string();
  const auto said = [this](const std::string& source) {
    session_.apply(gui::StartMirror{source});
    return session_.view().trouble;
  };
  EXPECT_EQ(said("camera:" + picture), gui::tr("camera.is_picture", picture));
  const std::string place = folder.path().string();
  EXPECT_EQ(said(place), gui::tr("camera.is_folder", place));
  EXPECT_EQ(said("camera:" + place + "/no.mp4"), gui::tr("camera.no_film", place + "/no.mp4"));
  EXPECT_EQ(said("no.mp4"), gui::tr("camera.no_film", "no.mp4"));
  EXPECT_TRUE(opened_.empty());
  EXPECT_EQ(said("camera:" + film), "");
  EXPECT_EQ(opened_, std::vector<std::string>{"camera:" + film});
}

TEST_F(MirrorSessionTest, ACameraOfDevIsLeftToItsReader) {
  session_.apply(gui::StartMirror{"camera:/dev/no_such_camera"});
  EXPECT_EQ(opened_, std::vector<std::string>{"camera:/dev/no_such_camera"});
}

TEST_F(MirrorSessionTest, OrdersAreHandedOnAndCarriedOutWhenTheCameraSaysSo) {
  session_.apply(gui::StartMirror{"camera"});
  see();
  static_cast<void>(session_.advance());
  session_.apply(gui::GoLive{"0.0.0.0", 4650});
  ASSERT_EQ(script_.orders.size(), 1U);
  EXPECT_EQ(script_.orders[0], (preview::Order{preview::GoLive{"0.0.0.0", 4650}}));
  EXPECT_EQ(session_.view().phase, Phase::Private);
  script_.state.live = "0.0.0.0:4650";
  script_.state.watching = 2;
  static_cast<void>(session_.advance());
  EXPECT_EQ(session_.view().phase, Phase::Live);
  EXPECT_EQ(session_.view().watching, 2U);
  session_.apply(gui::GoPrivate{});
  EXPECT_EQ(script_.orders.back(), preview::Order{preview::GoPrivate{}});
}

TEST_F(MirrorSessionTest, WithTheCameraOffGoingLiveOpensWhatItNames) {
  session_.apply(gui::GoLive{"0.0.0.0", 4650});
  EXPECT_TRUE(opened_.empty()) << "it names nothing";
  session_.apply(gui::GoLive{"0.0.0.0", 4650, film_});
  EXPECT_EQ(opened_, std::vector<std::string>{film_});
  EXPECT_EQ(script_.orders.size(), 1U);
}

TEST_F(MirrorSessionTest, StopEndsItInItsOwnTime) {
  session_.apply(gui::StartMirror{"camera"});
  see();
  session_.apply(gui::StopMirror{});
  EXPECT_TRUE(script_.asked_to_end);
  static_cast<void>(session_.advance());
  EXPECT_EQ(session_.view().phase, Phase::Ending);
  lose(Trouble::Kind::None);
  static_cast<void>(session_.advance());
  EXPECT_EQ(session_.view().phase, Phase::Off);
  EXPECT_EQ(session_.view().trouble, "");
  EXPECT_EQ(session_.view().seen, nullptr);
  EXPECT_FALSE(script_.there);
}

TEST_F(MirrorSessionTest, ACameraThatGivesNoMoreIsAFailure) {
  session_.apply(gui::StartMirror{"camera"});
  see();
  lose(Trouble::Kind::NoPictures);
  static_cast<void>(session_.advance());
  EXPECT_EQ(session_.view().trouble, gui::tr("camera.no_more"));
  EXPECT_FALSE(session_.view().expected);
}

TEST_F(MirrorSessionTest, AFilmThatGivesNoMoreIsOver) {
  session_.apply(gui::StartMirror{"camera:" + film_});
  see();
  lose(Trouble::Kind::NoPictures);
  static_cast<void>(session_.advance());
  EXPECT_EQ(session_.view().trouble, gui::tr("camera.film_over"));
  EXPECT_TRUE(session_.view().expected);
}

TEST_F(MirrorSessionTest, WhatItDiedOfStaysToBeReadUntilItStartsAgain) {
  session_.apply(gui::StartMirror{"camera"});
  script_.state.over = true;
  script_.state.ended = {Trouble::Kind::Said, "/dev/video0: there are no pictures in it"};
  static_cast<void>(session_.advance());
  static_cast<void>(session_.advance());
  EXPECT_EQ(session_.view().trouble, "/dev/video0: there are no pictures in it");
  session_.apply(gui::StartMirror{"camera"});
  EXPECT_EQ(session_.view().trouble, "");
  EXPECT_EQ(session_.view().phase, Phase::Starting);
}

TEST_F(MirrorSessionTest, WhoLacksTheModelsIsToldWhatToDoAndNotWhichFileIsMissing) {
  session_.apply(gui::StartMirror{"camera"});
  script_.state.over = true;
  script_.state.ended = {
      Trouble::Kind::Said,
      "/usr/share/aucast/models/detection.tflite: the models that read faces are "
      "not installed; '/usr/share/aucast/scripts/install_models.sh "
      "/usr/share/aucast' fetches them"};
  static_cast<void>(session_.advance());
  const std::string& trouble = session_.view().trouble;
  EXPECT_NE(trouble.find("\n/usr/share/aucast/scripts/install_models.sh /usr/share/aucast\n"),
            std::string::npos)
      << trouble;
  EXPECT_EQ(trouble.find("tflite"), std::string::npos) << trouble;
  const std::string sources = gui::tr("camera.in_sources");
  EXPECT_EQ(trouble.find(sources), std::string::npos) << "the path says where the script is";
  session_.apply(gui::StartMirror{"camera"});
  lose(Trouble::Kind::Said);
  script_.state.ended.said =
      "data/models/detection.tflite: the models that read faces are not installed; "
      "'scripts/install_models.sh data' fetches them";
  static_cast<void>(session_.advance());
  EXPECT_NE(session_.view().trouble.find(sources + ":\n\nscripts/install_models.sh data\n"),
            std::string::npos)
      << session_.view().trouble;
}

TEST_F(MirrorSessionTest, AnAddressThatIsNoneIsASentenceThatStays) {
  session_.apply(gui::StartMirror{"camera"});
  see();
  script_.state.own.address = "127.0.0.1:99999";
  EXPECT_EQ(session_.advance(), std::nullopt);
  const std::string trouble = session_.view().trouble;
  EXPECT_NE(trouble, "");
  EXPECT_EQ(session_.view().phase, Phase::Off);
  EXPECT_FALSE(script_.there);
  EXPECT_EQ(session_.advance(), std::nullopt);
  EXPECT_EQ(session_.view().trouble, trouble);
}

TEST_F(MirrorSessionTest, WithoutAuTransmitterIsASentence) {
  refused_ = Error{ErrorKind::Unreadable, "not there"};
  session_.apply(gui::StartMirror{"camera"});
  EXPECT_EQ(session_.view().trouble, gui::tr("camera.not_installed"));
  EXPECT_FALSE(session_.running());
  refused_ = Error{ErrorKind::Failed, "no more processes"};
  session_.apply(gui::StartMirror{"camera"});
  EXPECT_EQ(session_.view().trouble, "no more processes");
}

TEST_F(MirrorSessionTest, AFilmMayBeInTheHomeFolder) {
  const test::HomeVariable home;
  home.folder().write("talk.mp4", "");
  for (const char* source : {"~/talk.mp4", "camera:~/talk.mp4"}) {
    session_.apply(gui::StartMirror{source});
    EXPECT_EQ(session_.view().trouble, "");
    lose(Trouble::Kind::NoPictures);
    static_cast<void>(session_.advance());
  }
  EXPECT_EQ(opened_, (std::vector{home.in("talk.mp4"), "camera:" + home.in("talk.mp4")}));
}

}  // namespace
}  // namespace aucast::app
