#include "client/app/window/files/gallery_session.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <gtest/gtest.h>

#include "tests/support/home_variable.h"

namespace aucast::app {
namespace {

/// A gallery of three pictures or more, of which the next one is drawn when the test says so.
class GallerySessionTest : public testing::Test {
 protected:
  void SetUp() override {
    gui::GallerySettings settings;
    settings.folder = "/pictures";
    ask(gui::ChangeGallery{settings});
  }
  void ask(const gui::GalleryCommand& command) { session_.apply(command, shown_); }
  Result<std::string> make(const PlayerOptions& options, BackgroundWork::Course& course) {
    made_with_ = options;
    for (std::size_t drawn = 0; drawn < pictures_; ++drawn) {
      std::unique_lock lock(mutex_);
      const bool may = news_.wait(lock, course.stop(), [&] { return may_draw_ > drawn; });
      if (!may) return Error{ErrorKind::Failed, "stopped"};
      course.reached(drawn + 1, pictures_);
      drawn_ = drawn + 1;
      news_.notify_all();
    }
    return std::string("three pictures");
  }
  /// Returns once so many pictures are drawn.
  void draw(std::size_t pictures) {
    std::unique_lock lock(mutex_);
    may_draw_ = pictures;
    news_.notify_all();
    news_.wait(lock, [&] { return drawn_ == pictures; });
  }
  void end() {
    session_.wait();
    session_.advance(now_);
  }

  Instant now_{std::chrono::hours(1)};
  PlayerOptions shown_;
  PlayerOptions made_with_;
  std::mutex mutex_;
  std::condition_variable_any news_;
  std::size_t pictures_ = 3;
  std::size_t may_draw_ = 0;
  std::size_t drawn_ = 0;
  /// As many as there are sections, and no sweep but that of AU 12.
  static Result<std::size_t> count(const PlayerOptions& options) {
    const auto& sweeps = options.gallery.sweeps;
    if (!sweeps.empty() && sweeps != std::vector<std::string>{"12"}) {
      return Error{ErrorKind::Usage, "no such sweep"};
    }
    return options.gallery.only.size();
  }
  GallerySession session_{[this](const PlayerOptions& options, BackgroundWork::Course& course) {
                            return make(options, course);
                          },
                          count};
  const gui::GalleryView& view_ = session_.view();
};

TEST_F(GallerySessionTest, SaysHowFarItIsAndWhatCameOfIt) {
  shown_.face.face = "marek";
  ask(gui::OpenGallery{});
  EXPECT_TRUE(view_.open);
  ask(gui::BeginGallery{});
  EXPECT_TRUE(view_.running);
  draw(2);
  session_.advance(now_);
  EXPECT_EQ(view_.drawn, 2U);
  EXPECT_EQ(view_.total, 3U);
  EXPECT_TRUE(view_.running);
  ask(gui::CloseGallery{});
  EXPECT_TRUE(view_.running) << "it goes on without its dialog";
  draw(3);
  end();
  EXPECT_FALSE(view_.running);
  EXPECT_EQ(view_.outcome, "three pictures");
  EXPECT_FALSE(view_.failed);
  EXPECT_EQ(made_with_.face.face, "marek");
  EXPECT_EQ(made_with_.gallery.folder, "/pictures");
  EXPECT_EQ(made_with_.gallery.only, (std::vector<std::string>{"aus", "prototypes"}));
  EXPECT_TRUE(made_with_.gallery.sweeps.empty()) << "that section is not wanted";
  EXPECT_EQ(made_with_.output.width, 600);
}

TEST_F(GallerySessionTest, TellsHowLongTheRestTakesOnceAFewAreDrawn) {
  pictures_ = 11;
  ask(gui::BeginGallery{});
  const auto drawn_at = [this](std::size_t pictures, int second) {
    draw(pictures);
    now_ = Instant(std::chrono::hours(1) + std::chrono::seconds(second));
    session_.advance(now_);
    return view_.left_s;
  };
  EXPECT_EQ(drawn_at(1, 20), std::nullopt) << "the first one tells little";
  EXPECT_EQ(drawn_at(2, 21), std::nullopt);
  EXPECT_EQ(drawn_at(4, 26), 14) << "three in 6 s, seven to come";
  EXPECT_EQ(drawn_at(4, 90), 14) << "nothing new is known";
  draw(11);
  end();
  ask(gui::BeginGallery{});
  EXPECT_EQ(view_.left_s, std::nullopt);
}

TEST_F(GallerySessionTest, IsCancelledAndCanBeginAgain) {
  ask(gui::BeginGallery{});
  ask(gui::CancelGallery{});
  EXPECT_TRUE(view_.ending);
  end();
  EXPECT_FALSE(view_.running);
  EXPECT_FALSE(view_.failed) << "it was wanted so";
  EXPECT_TRUE(view_.stopped) << "but it is not complete";
  EXPECT_EQ(view_.outcome, "stopped");
  EXPECT_FALSE(view_.ending);
  ask(gui::BeginGallery{});
  draw(3);
  end();
  EXPECT_FALSE(view_.running);
  EXPECT_FALSE(view_.stopped);
  EXPECT_EQ(view_.outcome, "three pictures");
}

TEST_F(GallerySessionTest, WhoLeavesNeedNotWaitForAllPictures) {
  {
    GallerySession another([this](const PlayerOptions& options,
                                  BackgroundWork::Course& course) { return make(options, course); },
                           count);
    another.apply(gui::ChangeGallery{view_.settings}, shown_);
    another.apply(gui::BeginGallery{}, shown_);
  }
  EXPECT_EQ(drawn_, 0U) << "make() waits for pictures that never may be drawn";
}

TEST_F(GallerySessionTest, SaysBeforeItBeginsHowManyPicturesItWouldBe) {
  ask(gui::OpenGallery{});
  EXPECT_EQ(view_.planned, 2U);
  gui::GallerySettings settings = view_.settings;
  settings.sections.back() = true;
  ask(gui::ChangeGallery{settings});
  EXPECT_EQ(view_.planned, 3U);
  settings.sweeps = "twelve";
  ask(gui::ChangeGallery{settings});
  EXPECT_EQ(view_.planned, 0U);
  EXPECT_EQ(view_.complaint, "no such sweep");
  settings.sections = {};
  ask(gui::ChangeGallery{settings});
  EXPECT_EQ(view_.planned, 0U);
  EXPECT_EQ(view_.complaint, "") << "that nothing is chosen is said by problem()";
}

TEST_F(GallerySessionTest, WithoutAFolderNothingBegins) {
  gui::GallerySettings settings;
  ask(gui::ChangeGallery{settings});
  ask(gui::BeginGallery{});
  EXPECT_FALSE(view_.running);
  EXPECT_EQ(gui::problem(settings), "Choose a folder for the pictures.");
  settings.folder = "x";
  EXPECT_EQ(gui::problem(settings), "");
  settings.width = 12;
  EXPECT_EQ(gui::problem(settings), "width and height must be 16 to 4096 pixels");
  settings.width = 512;
  settings.sections.back() = true;
  settings.sweeps = "12 6,12  happiness";
  EXPECT_EQ(gui::wanted_sweeps(settings), (std::vector<std::string>{"12", "6,12", "happiness"}));
  settings.sweeps = " ";
  EXPECT_EQ(gui::problem(settings), "Name the AUs or expressions to sweep.");
  settings.sections = {};
  EXPECT_EQ(gui::problem(settings), "Choose what is to be drawn.");
}

TEST_F(GallerySessionTest, ItsFolderMayBeInTheHomeFolder) {
  const test::HomeVariable home;
  gui::GallerySettings settings;
  settings.folder = "~/pictures";
  ask(gui::ChangeGallery{settings});
  EXPECT_EQ(session_.view().settings.folder, "~/pictures") << "as long as it is typed";
  ask(gui::BeginGallery{});
  draw(3);
  end();
  EXPECT_EQ(made_with_.gallery.folder, home.in("pictures"));
}

}  // namespace
}  // namespace aucast::app
