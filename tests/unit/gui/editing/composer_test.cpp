#include "client/gui/editing/composer.h"

#include <memory>

#include <gtest/gtest.h>

#include "tests/support/composed.h"

namespace aucast::gui {
namespace {

class ComposerTest : public testing::Test {
 protected:
  /// The AUs of the timeline, one digit each.
  [[nodiscard]] std::string order() const {
    std::string text;
    for (const auto& keyframe : composer_.keyframes()) {
      for (const AuTerm& term : canonical_terms(keyframe->aus)) text += std::to_string(term.number);
    }
    return text;
  }

  Composer composer_;
};

TEST_F(ComposerTest, ANewFaceIsAddedAtTheEnd) {
  EXPECT_FALSE(composer_.unsaved());
  composer_.set_au(12, 60, 80, false);
  EXPECT_TRUE(composer_.begun()) << "it is nowhere else";
  EXPECT_FALSE(composer_.unsaved()) << "the stream does not have it";
  EXPECT_TRUE(composer_.keyframes().empty());
  composer_.add();
  EXPECT_FALSE(composer_.begun());
  EXPECT_TRUE(composer_.unsaved());
  ASSERT_EQ(composer_.keyframes().size(), 1U);
  EXPECT_FLOAT_EQ(composer_.keyframes()[0]->aus.left[12], 0.6F);
  EXPECT_FLOAT_EQ(composer_.keyframes()[0]->aus.right[12], 0.8F);
  EXPECT_EQ(composer_.keyframes()[0]->ms, 500U);
}

TEST_F(ComposerTest, AChosenKeyframeIsChangedInItsPlace) {
  test::compose(composer_, 3);
  composer_.choose(1);
  composer_.set_aus({}, false);
  composer_.set_au(9, 50, 50, false);
  composer_.set_time(1200, false);
  EXPECT_EQ(order(), "193");
  EXPECT_EQ(composer_.keyframes()[1]->ms, 1200U);
  composer_.set_time(std::nullopt, false);
  EXPECT_FALSE(composer_.keyframes()[1]->ms.has_value());
  composer_.set_time(99'999'999, false);
  EXPECT_EQ(composer_.keyframes()[1]->ms, Composer::kMsMax);
}

TEST_F(ComposerTest, KeyframesAreMovedDoubledAndRemoved) {
  test::compose(composer_, 3);
  composer_.move(-1);
  EXPECT_EQ(order(), "123") << "nothing is chosen";
  composer_.choose(2);
  composer_.move(-1);
  EXPECT_EQ(order(), "132");
  EXPECT_EQ(composer_.chosen(), 1U);
  composer_.move(+1);
  composer_.move(+1);
  EXPECT_EQ(order(), "123");
  composer_.choose(0);
  composer_.move(-1);
  composer_.add();
  EXPECT_EQ(order(), "1123");
  EXPECT_EQ(composer_.chosen(), 1U);
  composer_.remove();
  composer_.remove();
  EXPECT_EQ(order(), "13");
  composer_.remove();
  EXPECT_EQ(composer_.chosen(), 0U);
  composer_.remove();
  EXPECT_TRUE(composer_.keyframes().empty());
  EXPECT_FALSE(composer_.chosen().has_value());
  composer_.remove();
}

TEST_F(ComposerTest, WhatIsNotThereIsIgnored) {
  test::compose(composer_, 1);
  composer_.choose(5);
  composer_.set_au(0, 50, 50, false);
  composer_.set_au(100, 50, 50, false);
  composer_.undo();
  EXPECT_EQ(order(), "") << "none of them was a step";
  composer_.set_au(5, 900, -3, false);
  EXPECT_EQ(composer_.current().aus.left[5], 1.0F);
  EXPECT_EQ(composer_.current().aus.right[5], 0.0F);
}

TEST_F(ComposerTest, EveryStepCanBeTakenBackAndDoneAgain) {
  test::compose(composer_, 2);
  composer_.choose(0);
  composer_.set_au(7, 10, 10, false);
  composer_.set_au(7, 20, 20, true);
  composer_.set_au(7, 30, 30, true);
  composer_.remove();
  composer_.undo();
  EXPECT_EQ(order(), "172");
  composer_.undo();
  EXPECT_EQ(order(), "12") << "a drag is one step";
  while (composer_.can_undo()) composer_.undo();
  EXPECT_TRUE(composer_.keyframes().empty());
  while (composer_.can_redo()) composer_.redo();
  EXPECT_EQ(order(), "2");
}

TEST_F(ComposerTest, OfALongStreamFewerStepsCanBeUndone) {
  const auto undone = [this] {
    int steps = 0;
    for (; composer_.can_undo(); ++steps) composer_.undo();
    return steps;
  };
  const auto load = [this](std::size_t count) {
    const auto keyframe = std::make_shared<const ComposedKeyframe>();
    composer_.load(Composer::Keyframes(count, keyframe), "/tmp/long.txt", "");
  };
  constexpr std::size_t kPlace = 2 * sizeof(Composer::Keyframes::value_type);
  load(Composer::kUndoBytesMax / kPlace / 10);
  for (std::uint32_t i = 0; i < 30; ++i) composer_.set_time(1000 + i, false);
  EXPECT_EQ(undone(), 9) << "ten would take more than is kept, with what each step changed";
  load(Composer::kUndoBytesMax / kPlace);
  for (std::uint32_t i = 0; i < 3; ++i) composer_.set_time(1000 + i, false);
  EXPECT_EQ(undone(), 1) << "the last step can be undone whatever it takes";
}

TEST_F(ComposerTest, AnotherStreamIsAStepToo) {
  test::compose(composer_, 2);
  composer_.begin_anew();
  EXPECT_TRUE(composer_.keyframes().empty());
  EXPECT_FALSE(composer_.unsaved());
  composer_.load({std::make_shared<const ComposedKeyframe>()}, "/tmp/x.txt", "A talk");
  EXPECT_EQ(composer_.file(), "/tmp/x.txt");
  EXPECT_EQ(composer_.title(), "A talk");
  EXPECT_EQ(composer_.chosen(), 0U);
  EXPECT_FALSE(composer_.unsaved());
  composer_.undo();
  composer_.undo();
  EXPECT_EQ(order(), "12");
  EXPECT_TRUE(composer_.unsaved());
  EXPECT_TRUE(composer_.file().empty());
  EXPECT_TRUE(composer_.title().empty());
}

TEST_F(ComposerTest, SavedIsWhatTheFileHas) {
  test::compose(composer_, 2);
  EXPECT_TRUE(composer_.unsaved());
  composer_.saved("a.txt");
  EXPECT_FALSE(composer_.unsaved());
  composer_.choose(0);
  EXPECT_FALSE(composer_.unsaved());
  composer_.remove();
  EXPECT_TRUE(composer_.unsaved());
  composer_.saved("a.txt");
  composer_.undo();
  EXPECT_TRUE(composer_.unsaved()) << "the file has only one now";
}

TEST_F(ComposerTest, ANewFaceWaitsWhileAnotherIsLookedAt) {
  test::compose(composer_, 1);
  composer_.set_au(12, 70, 70, false);
  composer_.choose(0);
  composer_.choose(std::nullopt);
  EXPECT_FLOAT_EQ(composer_.current().aus.left[12], 0.7F);
}

}  // namespace
}  // namespace aucast::gui
