// The camera of the window, with a script in the place of au-transmitter. What the session makes of
// what it tells is in playing/mirror_session_test.cpp.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>

#include "client/gui/texts/texts.h"
#include "common/files.h"
#include "common/preview/preview_writer.h"
#include "tests/support/eventually.h"
#include "tests/support/loopback.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"

namespace aucast::app {
namespace {

using Phase = gui::MirrorView::Phase;

class WindowMirror : public SessionOnDefaultFace {
 protected:
  void begin(const std::string& script) {
    folder_.write("record", preview::seen_record({1, 1, {1, 2, 3}, {}, {}}));
    options_.mirror.program = folder_.write(
        "au-transmitter", "#!/bin/sh\ncd '" + folder_.path().string() + "'\n" + script);
    std::filesystem::permissions(options_.mirror.program, std::filesystem::perms::owner_all);
    options_.shows_mirror = true;
    session_.emplace(*assets_, options_, nullptr, stats_);
  }
  bool becomes(const std::function<bool(const gui::MirrorView&)>& wanted) {
    return test::eventually([&] {
      session_->advance(clock_.now());
      return wanted(model().mirror);
    });
  }
  bool reaches(Phase phase) {
    return becomes([phase](const gui::MirrorView& view) { return view.phase == phase; });
  }
  void ask(const gui::MirrorCommand& command) { session_->apply(command, clock_.now()); }

  test::TempFolder folder_;
};

TEST_F(WindowMirror, IsPrivateUntilItIsToldToGoLiveAndEnds) {
  // Somebody listens there: a refused connection could be "no connection" again already.
  const test::LoopbackSocket child = test::listen_on_loopback();
  begin("echo 'listening on " + child.address() +
        " 0a1b'; cat record\n"
        "read order port bind; echo live $bind:$port; read order; echo private; read order");
  EXPECT_TRUE(model().mirror.wanted);
  ASSERT_TRUE(reaches(Phase::Private));
  EXPECT_NE(model().mirror.seen, nullptr);
  EXPECT_NE(model().playing.state, "no connection") << "its own stream is played";
  EXPECT_TRUE(session_->playback().servers().recent().empty()) << "and not remembered";
  const int window = ::accept(child.descriptor, nullptr, nullptr);
  std::string hello;
  for (char letter = 0; letter != '}' && ::recv(window, &letter, 1, 0) == 1;) hello += letter;
  EXPECT_NE(hello.find("token=0a1b"), std::string::npos) << hello;
  ask(gui::GoLive{"127.0.0.1", 4650});
  ASSERT_TRUE(reaches(Phase::Live));
  EXPECT_EQ(model().mirror.live, "127.0.0.1:4650");
  ask(gui::GoPrivate{});
  ASSERT_TRUE(reaches(Phase::Private));
  ask(gui::StopMirror{});
  ASSERT_TRUE(reaches(Phase::Off));
  EXPECT_EQ(model().mirror.trouble, "");
  EXPECT_EQ(model().mirror.seen, nullptr);
  ::close(window);
  ::close(child.descriptor);
}

TEST_F(WindowMirror, SaysWhatItsChildDiedOfAndStartsAgain) {
  begin(
      "if [ -e second ]; then echo 'listening on 127.0.0.1:1'; cat record; read order; fi\n"
      "touch second; echo 'au-transmitter: /dev/video0: there are no pictures in it' >&2; exit 1");
  ASSERT_TRUE(becomes([](const gui::MirrorView& view) { return !view.trouble.empty(); }));
  EXPECT_EQ(model().mirror.trouble, "/dev/video0: there are no pictures in it");
  EXPECT_EQ(model().mirror.phase, Phase::Off);
  ask(gui::StartMirror{"camera"});
  ASSERT_TRUE(reaches(Phase::Private));
  EXPECT_EQ(model().mirror.trouble, "");
}

TEST_F(WindowMirror, PlaysAFilmThatWasChosenAndTakesItsEndForNoFailure) {
  begin("echo \"$@\" > asked; echo 'listening on 127.0.0.1:1'; cat record");
  ASSERT_TRUE(reaches(Phase::Off));
  const std::string film = folder_.write("me.mp4", "");
  session_->apply(gui::Browse{gui::Purpose::CameraFilm}, clock_.now());
  session_->apply(gui::ChooseFile{film}, clock_.now());
  EXPECT_EQ(model().mirror.source, "camera:" + film);
  ask(gui::StartMirror{model().mirror.source});
  ASSERT_TRUE(reaches(Phase::Off));
  const auto asked = read_file(folder_.path() / "asked");
  ASSERT_TRUE(asked.has_value());
  EXPECT_NE(asked->find("camera:" + film), std::string::npos);
  EXPECT_TRUE(model().mirror.expected);
  EXPECT_EQ(model().mirror.trouble, gui::tr("camera.film_over"));
}

TEST_F(WindowMirror, AFilmGoesLiveAtOnce) {
  begin(
      "if [ -e second ]; then echo 'listening on 127.0.0.1:1'; read order port bind\n"
      "echo live $bind:$port; cat record; read order; fi; touch second; exit 1");
  ASSERT_TRUE(reaches(Phase::Off));
  ask(gui::GoLive{"127.0.0.1", 4650, "camera:" + folder_.write("me.mp4", "").string()});
  ASSERT_TRUE(reaches(Phase::Live));
  EXPECT_EQ(model().mirror.live, "127.0.0.1:4650");
}

TEST_F(WindowMirror, WithoutAuTransmitterIsASentence) {
  options_.mirror.program = "aucast-no-such-program";
  options_.shows_mirror = true;
  session_.emplace(*assets_, options_, nullptr, stats_);
  session_->advance(clock_.now());
  EXPECT_NE(model().mirror.trouble.find("au-transmitter, is not on this computer"),
            std::string::npos);
  EXPECT_EQ(model().mirror.phase, Phase::Off);
}

}  // namespace
}  // namespace aucast::app
