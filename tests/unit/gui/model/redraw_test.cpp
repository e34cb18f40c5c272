#include "client/gui/model/redraw.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

GuiModel playing_at(Milliseconds position) {
  GuiModel model;
  model.local.open = true;
  model.local.playing = true;
  model.local.position = position;
  return model;
}

int due(const GuiModel& shown, const GuiModel& now) {
  GuiModel compared = now;
  const int frames = frames_due(shown, compared);
  EXPECT_EQ(compared, now) << "it is left as it was";
  return frames;
}

TEST(Redraw, NothingIsDrawnForNothing) {
  EXPECT_EQ(due(GuiModel(), GuiModel()), 0);
}

TEST(Redraw, AStillFaceThatPlaysOnIsDrawnTenTimesASecond) {
  GuiModel shown = playing_at(Milliseconds(0));
  int frames = 0;
  for (int ms = 0; ms < 6000; ms += 10) {
    const GuiModel now = playing_at(Milliseconds(ms));
    const int more = due(shown, now);
    frames += more;
    if (more > 0) shown = now;
  }
  EXPECT_EQ(frames, 59);
}

TEST(Redraw, AJumpBackIsSeenAtOnce) {
  EXPECT_EQ(due(playing_at(Milliseconds(900)), playing_at(Milliseconds(100))), 1);
}

TEST(Redraw, WhereItStandsIsExactOnceItStands) {
  GuiModel stands = playing_at(Milliseconds(10));
  stands.local.playing = false;
  EXPECT_EQ(due(playing_at(Milliseconds(0)), stands), kFramesAfterChange);
  GuiModel a_frame_on = stands;
  a_frame_on.local.position += Milliseconds(10);
  EXPECT_EQ(due(stands, a_frame_on), kFramesAfterChange);
}

TEST(Redraw, APlotThatGoesOnTakesOneFrame) {
  GuiModel shown;
  shown.playing.receiver_history = {0.5F};
  GuiModel now = shown;
  now.playing.receiver_history = {0.5F, 0.5F};
  now.playing.au_history = {{12, {1}}};
  EXPECT_EQ(due(shown, now), 1);
}

TEST(Redraw, WhateverElseChangesIsDrawnWhileItPlays) {
  GuiModel now = playing_at(Milliseconds(10));
  now.notice.text = "picture saved";
  EXPECT_EQ(due(playing_at(Milliseconds(0)), now), kFramesAfterChange);
}

}  // namespace
}  // namespace aucast::gui
