#include "client/app/window/window_keys.h"

#include <set>

#include <gtest/gtest.h>

#include "client/gui/model/stream_view.h"

namespace aucast::app {
namespace {

using render::Key;

template <typename Wanted>
const Wanted* command_of(Key key) {
  const KeyMeaning* meaning = meaning_of(key);
  const auto* command = meaning != nullptr ? std::get_if<gui::GuiCommand>(meaning) : nullptr;
  return command != nullptr ? gui::command_if<Wanted>(*command) : nullptr;
}

TEST(WindowKeys, EveryKeyHasAMeaning) {
  EXPECT_EQ(meaning_of(Key::None), nullptr);
  for (int key = static_cast<int>(Key::Quit); key <= static_cast<int>(Key::Save); ++key) {
    EXPECT_NE(meaning_of(static_cast<Key>(key)), nullptr) << key;
  }
}

TEST(WindowKeys, WhatGoesBothWaysHasAKeyForEach) {
  ASSERT_TRUE(command_of<gui::SeekBy>(Key::Left) && command_of<gui::SeekBy>(Key::Right));
  EXPECT_EQ(command_of<gui::SeekBy>(Key::Left)->time, Milliseconds(-5'000));
  EXPECT_EQ(command_of<gui::SeekBy>(Key::Right)->time, Milliseconds(5'000));
  ASSERT_TRUE(command_of<gui::StepFrame>(Key::Comma) && command_of<gui::StepFrame>(Key::Period));
  EXPECT_EQ(command_of<gui::StepFrame>(Key::Comma)->direction, -1);
  EXPECT_EQ(command_of<gui::StepFrame>(Key::Period)->direction, 1);
  EXPECT_LT(std::get<ChangeVolume>(*meaning_of(Key::Quieter)).percent, 0);
  EXPECT_GT(std::get<ChangeVolume>(*meaning_of(Key::Louder)).percent, 0);
  EXPECT_EQ(std::get<SessionAct>(*meaning_of(Key::Undo)), &WindowSession::undo);
  EXPECT_EQ(std::get<SessionAct>(*meaning_of(Key::Redo)), &WindowSession::redo);
}

TEST(WindowKeys, OnlyEscapeClosesAndOnlyQuitLeaves) {
  std::multiset<WindowAct> acts;
  for (int key = static_cast<int>(Key::Quit); key <= static_cast<int>(Key::Save); ++key) {
    if (const auto* act = std::get_if<WindowAct>(meaning_of(static_cast<Key>(key)))) {
      acts.insert(*act);
    }
  }
  EXPECT_EQ(acts, (std::multiset<WindowAct>{WindowAct::Leave, WindowAct::CloseNearest,
                                            WindowAct::ToggleFullScreen, WindowAct::ToggleBare,
                                            WindowAct::TogglePanel, WindowAct::ToggleKeys}));
  EXPECT_EQ(std::get<WindowAct>(*meaning_of(Key::Quit)), WindowAct::Leave);
  EXPECT_EQ(std::get<WindowAct>(*meaning_of(Key::Escape)), WindowAct::CloseNearest);
}

}  // namespace
}  // namespace aucast::app
