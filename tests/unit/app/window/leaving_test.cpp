#include "client/app/window/leaving.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

constexpr Losses kNothing;
constexpr Losses kUnsaved{.unsaved = true};
constexpr Losses kUnfinished{.unfinished = true};
constexpr Losses kBoth{.unsaved = true, .unfinished = true};
constexpr gui::Leave kStay;
constexpr gui::Leave kLeave{.really = true};
constexpr gui::Leave kSave{.saves = true};

/// The user wants to leave, and was asked.
Leaving asked(const Losses& losses = kUnsaved) {
  Leaving leaving;
  leaving.wish(losses);
  EXPECT_TRUE(leaving.asks());
  EXPECT_FALSE(leaving.leaves());
  return leaving;
}

TEST(Leaving, AsksOnlyIfSomethingWouldBeLost) {
  Leaving leaving;
  EXPECT_FALSE(leaving.asks());
  EXPECT_FALSE(leaving.leaves());
  leaving.wish(kNothing);
  EXPECT_TRUE(leaving.leaves());
  EXPECT_FALSE(leaving.asks());
  Leaving twice = asked(kUnfinished);
  twice.wish(kUnfinished);
  EXPECT_TRUE(twice.asks());
  EXPECT_FALSE(twice.leaves()) << "however often it is wished";
}

TEST(Leaving, TheAnswerCounts) {
  Leaving stays = asked();
  stays.answer(kStay, kUnsaved, false);
  EXPECT_FALSE(stays.asks());
  EXPECT_FALSE(stays.leaves());
  Leaving leaves = asked(kBoth);
  leaves.answer(kLeave, kBoth, false);
  EXPECT_TRUE(leaves.leaves());
}

TEST(Leaving, LeavesOnceAllIsSaved) {
  Leaving saved = asked();
  saved.answer(kSave, kNothing, false);
  EXPECT_TRUE(saved.leaves());
  Leaving failed = asked();
  failed.answer(kSave, kUnsaved, false);
  EXPECT_FALSE(failed.leaves());
  EXPECT_FALSE(failed.asks()) << "why it was not saved is to be read";
}

TEST(Leaving, AsksAgainAboutWhatCannotBeSaved) {
  Leaving leaving = asked(kBoth);
  leaving.answer(kSave, kUnfinished, false);
  EXPECT_TRUE(leaving.asks());
  EXPECT_FALSE(leaving.leaves());
}

TEST(Leaving, WaitsForTheFileToSaveTo) {
  Leaving leaving = asked();
  leaving.answer(kSave, kUnsaved, true);
  EXPECT_FALSE(leaving.asks());
  EXPECT_FALSE(leaving.leaves());
  leaving.chosen(kNothing);
  EXPECT_TRUE(leaving.leaves());
}

TEST(Leaving, ADialogThatIsClosedWithoutAFileEndsIt) {
  Leaving leaving = asked();
  leaving.answer(kSave, kUnsaved, true);
  leaving.chosen(kUnsaved);
  leaving.chosen(kNothing);
  EXPECT_FALSE(leaving.leaves()) << "that was saved for its own sake";
}

TEST(Leaving, AfterTheFileWasChosenItAsksAboutTheRest) {
  Leaving leaving = asked(kBoth);
  leaving.answer(kSave, kBoth, true);
  leaving.chosen(kUnfinished);
  EXPECT_TRUE(leaving.asks());
  EXPECT_FALSE(leaving.leaves());
}

TEST(Leaving, StopsAskingWhenNothingIsLeftToLose) {
  Leaving leaving = asked(kUnfinished);
  leaving.look(kUnfinished);
  EXPECT_TRUE(leaving.asks());
  leaving.look(kNothing);
  EXPECT_FALSE(leaving.asks());
  EXPECT_FALSE(leaving.leaves()) << "how the work ended is to be read";
}

}  // namespace
}  // namespace aucast::app
