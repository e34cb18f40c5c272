#include "client/app/window/input_pacer.h"

#include <vector>

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using render::InputEvent;
using Kind = InputEvent::Kind;

InputEvent move() {
  return {Kind::Move};
}
InputEvent button(int action) {
  return {Kind::Button, 0, 0, action};
}
InputEvent scroll() {
  return {Kind::Scroll};
}
InputEvent key(int code, int action, bool text) {
  InputEvent event{Kind::Key, code, 0, action};
  event.text = text;
  return event;
}
InputEvent character(char c) {
  return {Kind::Character, c};
}

InputEvent letter(char code, int action, render::Key meaning) {
  InputEvent event = key(code, action, true);
  event.meaning = meaning;
  return event;
}

constexpr int kEnter = 257;
constexpr int kControl = 341;

/// How many events each frame sees until none are left.
std::vector<std::size_t> frames(std::deque<InputEvent> waiting, bool typing = false) {
  InputPacer pacer;
  std::vector<std::size_t> shares;
  while (!waiting.empty() && shares.size() < 100) {
    shares.push_back(pacer.next(waiting, typing));
    for (std::size_t i = 0; i < shares.back(); ++i) waiting.pop_front();
  }
  EXPECT_TRUE(waiting.empty());
  return shares;
}

using Shares = std::vector<std::size_t>;

TEST(InputPacer, ATapTakesTwoFrames) {
  EXPECT_EQ(frames({button(1), button(0)}), (Shares{1, 1}));
}

TEST(InputPacer, APressWaitsUntilThePointerIsSeenThere) {
  EXPECT_EQ(frames({move(), move(), button(1), button(0)}), (Shares{2, 1, 1}));
}

TEST(InputPacer, AClickIsWhereThePointerWas) {
  EXPECT_EQ(frames({move(), button(1), button(0), move()}), (Shares{1, 1, 1, 1}));
}

TEST(InputPacer, WhatIsDraggedIsLetGoWhereThePointerIs) {
  EXPECT_EQ(frames({move(), button(1), move(), move(), button(0), move()}),
            (Shares{1, 1, 2, 1, 1}));
}

TEST(InputPacer, TheWheelTurnsWhatThePointerIsOver) {
  EXPECT_EQ(frames({move(), scroll(), scroll(), move()}), (Shares{1, 2, 1}));
}

TEST(InputPacer, TextIsTypedInOneFrame) {
  std::deque<InputEvent> typed;
  for (const char c : {'4', '4', '1'}) {
    typed.push_back(key(c, 1, true));
    typed.push_back(character(c));
    typed.push_back(key(c, 0, true));
  }
  EXPECT_EQ(frames(typed), (Shares{9}));
}

/// In a third frame it would be held long enough to repeat when drawing is slow.
TEST(InputPacer, AKeyThatActsIsTappedInTwoFrames) {
  EXPECT_EQ(frames({key(kEnter, 1, false), key(kEnter, 0, false)}), (Shares{1, 1}));
  EXPECT_EQ(frames({key(kEnter, 1, false), key(kEnter, 0, false), key(kEnter, 1, false),
                    key(kEnter, 0, false)}),
            (Shares{1, 1, 1, 1}));
}

/// Some keyboards and programs let Ctrl go first: the letter is then let go as if it was typed.
TEST(InputPacer, ALetterIsSeenWhileCtrlIsDown) {
  EXPECT_EQ(frames({key(kControl, 1, false), key('a', 1, false), key(kControl, 0, false),
                    key('a', 0, true), key('x', 1, true), character('x')}),
            (Shares{1, 0, 1, 2, 2}));
}

TEST(InputPacer, WhatFollowsACommandIsForWhatItOpens) {
  const std::deque<InputEvent> typed = {letter('o', 1, render::Key::O),
                                        character('o'),
                                        letter('o', 0, render::Key::None),
                                        letter('/', 1, render::Key::None),
                                        character('/'),
                                        letter('s', 1, render::Key::S),
                                        character('s')};
  EXPECT_EQ(frames(typed), (Shares{3, 4}));
  EXPECT_EQ(frames(typed, true), (Shares{7})) << "no command is given in a field";
  EXPECT_EQ(frames({letter('o', 1, render::Key::O), character('o'), button(1), button(0)}),
            (Shares{2, 1, 1}));
}

/// A click into a field and a letter at once: ImGui knows of the focus two frames later.
TEST(InputPacer, KeysWaitUntilTheFocusIsWhereTheClickPutIt) {
  EXPECT_EQ(frames({button(1), button(0), key('q', 1, true), character('q')}),
            (Shares{1, 1, 0, 2}));
}

TEST(InputPacer, WhatFollowsEnterWaitsUntilTheFieldIsLeft) {
  EXPECT_EQ(frames({character('7'), key(kEnter, 1, false), key('q', 1, true), character('q')}),
            (Shares{2, 0, 2}));
}

TEST(InputPacer, NothingIsSharedOutOfNothing) {
  InputPacer pacer;
  EXPECT_EQ(pacer.next({}, false), 0U);
}

}  // namespace
}  // namespace aucast::app
