#include "client/gui/editing/expression_editor.h"

#include <limits>

#include <gtest/gtest.h>

#include "client/gui/editing/channel_groups.h"
#include "tests/support/seeded.h"
#include "tests/unit/face/small_face.h"

namespace aucast::gui {
namespace {

class ExpressionEditorTest : public testing::Test {
 protected:
  [[nodiscard]] std::size_t channel(const char* name) const {
    const auto index = face_.channel_index(name);
    EXPECT_TRUE(index.has_value()) << name;
    return index.value_or(0);
  }
  [[nodiscard]] float value(const char* name) const { return editor_.activations()[channel(name)]; }

  face::Face face_ = face::test::small_face();
  ExpressionEditor editor_{face_, face_.recordings};
};

TEST_F(ExpressionEditorTest, BeginsWithTheNeutralFace) {
  EXPECT_EQ(editor_.activations(), std::vector<float>(face_.channels.size()));
  EXPECT_FALSE(editor_.unsaved());
  EXPECT_FALSE(editor_.can_undo());
  EXPECT_FALSE(editor_.can_redo());
  EXPECT_EQ(editor_.au(), std::nullopt);
}

TEST_F(ExpressionEditorTest, LinkedChannelsMoveTogether) {
  editor_.set(channel("right_lid_close"), 0.5F, false);
  EXPECT_EQ(value("left_lid_close"), 0.5F);
  editor_.set_linked(false);
  editor_.set(channel("left_lid_close"), 0.25F, false);
  EXPECT_EQ(value("right_lid_close"), 0.5F);
  EXPECT_EQ(value("left_lid_close"), 0.25F);
}

TEST_F(ExpressionEditorTest, ValuesStayInTheirRange) {
  editor_.set(channel("jaw"), 9, false);
  EXPECT_EQ(value("jaw"), 4);
  editor_.set(channel("jaw"), -1, false);
  EXPECT_EQ(value("jaw"), 0);
  editor_.set(channel("jaw"), 1, false);
  editor_.set(channel("jaw"), std::numeric_limits<float>::quiet_NaN(), false);
  EXPECT_EQ(value("jaw"), 1);
}

TEST_F(ExpressionEditorTest, ADragIsOneStep) {
  editor_.set(channel("jaw"), 0.1F, false);
  editor_.set(channel("jaw"), 0.2F, true);
  editor_.set(channel("jaw"), 0.3F, true);
  editor_.undo();
  EXPECT_EQ(value("jaw"), 0);
  EXPECT_FALSE(editor_.can_undo());
  editor_.redo();
  EXPECT_EQ(value("jaw"), 0.3F);
}

TEST_F(ExpressionEditorTest, WhatChangesNothingIsNoStep) {
  editor_.set(channel("jaw"), 0, false);
  editor_.neutral();
  editor_.revert();
  EXPECT_FALSE(editor_.can_undo());
}

TEST_F(ExpressionEditorTest, EditingAnAuIsUnsavedUntilSavedOrReverted) {
  const auto& [number, recording] = *std::next(face_.recordings.begin());
  editor_.load(number);
  EXPECT_EQ(editor_.au(), number);
  EXPECT_EQ(editor_.activations(), recording.activation);
  EXPECT_FALSE(editor_.unsaved());
  editor_.set(channel("jaw"), 2.5F, false);
  EXPECT_TRUE(editor_.unsaved());
  editor_.revert();
  EXPECT_FALSE(editor_.unsaved());
  EXPECT_EQ(editor_.activations(), recording.activation);
  editor_.undo();
  EXPECT_TRUE(editor_.unsaved());
  editor_.saved(number);
  EXPECT_FALSE(editor_.unsaved());
}

TEST_F(ExpressionEditorTest, UndoneAfterSavingIsUnsavedAgain) {
  editor_.load(77);
  editor_.set(channel("jaw"), 1, false);
  editor_.saved(77);
  editor_.undo();
  EXPECT_TRUE(editor_.unsaved());
  editor_.redo();
  EXPECT_FALSE(editor_.unsaved());
}

TEST_F(ExpressionEditorTest, OnAnotherFaceWhatIsUnsavedGoesAlongAndTheRestIsThatFaces) {
  editor_.load(26);
  editor_.set(channel("jaw"), 3, false);
  std::vector<std::string> before;
  for (const face::Channel& one : face_.channels) before.push_back(one.name);
  face_.channels.erase(face_.channels.begin());
  face_.channels[channel("jaw")].activation_max = 2;
  for (auto& [number, recording] : face_.recordings) {
    recording.activation.erase(recording.activation.begin());
  }
  face_.recordings[26].activation[channel("jaw")] = 1;
  editor_.change_face(before);
  EXPECT_EQ(editor_.activations().size(), face_.channels.size());
  EXPECT_TRUE(editor_.unsaved());
  EXPECT_EQ(value("jaw"), 2) << "as far as this face can";
  editor_.undo();
  EXPECT_FALSE(editor_.unsaved());
  EXPECT_EQ(value("jaw"), 1) << "its own recording";
  editor_.undo();
  EXPECT_EQ(editor_.activations(), std::vector<float>(face_.channels.size()));
}

TEST_F(ExpressionEditorTest, LoadingAnotherAuLosesNothing) {
  editor_.load(77);
  editor_.set(channel("jaw"), 1, false);
  editor_.load(78);
  EXPECT_EQ(value("jaw"), 0);
  editor_.undo();
  EXPECT_EQ(editor_.au(), 77);
  EXPECT_EQ(value("jaw"), 1);
  EXPECT_TRUE(editor_.unsaved());
}

TEST_F(ExpressionEditorTest, AnythingDoneAfterUndoEndsRedo) {
  editor_.set(channel("jaw"), 1, false);
  editor_.undo();
  EXPECT_TRUE(editor_.can_redo());
  editor_.set(channel("jaw"), 2, false);
  EXPECT_FALSE(editor_.can_redo());
  editor_.redo();
  EXPECT_EQ(value("jaw"), 2);
}

TEST_F(ExpressionEditorTest, UndoneAllTheWayEverythingIsAsItWas) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<std::vector<float>> seen{editor_.activations()};
  for (int i = 0; i < 200; ++i) {
    const int index = seeded.integer(0, static_cast<int>(face_.channels.size()) - 1);
    editor_.set_linked(seeded.chance(0.5));
    editor_.set(static_cast<std::size_t>(index), static_cast<float>(seeded.real(0.01, 1)), false);
    if (editor_.activations() != seen.back()) seen.push_back(editor_.activations());
  }
  const auto last = seen.back();
  while (editor_.can_undo()) {
    ASSERT_EQ(editor_.activations(), seen.back());
    seen.pop_back();
    editor_.undo();
  }
  EXPECT_EQ(seen.size(), 1U);
  while (editor_.can_redo()) editor_.redo();
  EXPECT_EQ(editor_.activations(), last);
}

TEST_F(ExpressionEditorTest, PartnersAreFoundByName) {
  EXPECT_EQ(partner_of(face_, channel("left_lid_close")), channel("right_lid_close"));
  EXPECT_EQ(partner_of(face_, channel("right_lid_close")), channel("left_lid_close"));
  EXPECT_EQ(partner_of(face_, channel("jaw")), std::nullopt);
}

TEST_F(ExpressionEditorTest, EveryChannelStandsInExactlyOneGroup) {
  std::vector<float> activations(face_.channels.size());
  for (std::size_t i = 0; i < activations.size(); ++i) activations[i] = static_cast<float>(i);
  std::vector<int> seen(face_.channels.size());
  for (const ChannelGroup& group : channel_groups(face_, activations)) {
    EXPECT_FALSE(group.rows.empty()) << group.name;
    for (const ChannelRow& row : group.rows) {
      ++seen[static_cast<std::size_t>(row.left)];
      EXPECT_EQ(row.left_value, static_cast<float>(row.left));
      if (row.right < 0) continue;
      ++seen[static_cast<std::size_t>(row.right)];
      EXPECT_EQ(row.right_value, static_cast<float>(row.right));
      EXPECT_FALSE(row.name.starts_with("left ")) << row.name;
    }
  }
  EXPECT_EQ(seen, std::vector<int>(face_.channels.size(), 1));
}

TEST_F(ExpressionEditorTest, GroupsAreThoseOfTheFace) {
  const auto groups = channel_groups(face_, editor_.activations());
  const auto group_of = [&](std::string_view name) -> std::string_view {
    for (const ChannelGroup& group : groups) {
      for (const ChannelRow& row : group.rows) {
        if (row.name == name) return group.name;
      }
    }
    return "nowhere";
  };
  EXPECT_EQ(group_of("jaw"), "Jaw, chin and neck");
  EXPECT_EQ(group_of("lid close"), "Eyes and cheeks");
  EXPECT_EQ(group_of("head up"), "Head");
}

}  // namespace
}  // namespace aucast::gui
