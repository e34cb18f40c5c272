#include "client/app/window/playing/sound_session.h"

#include <chrono>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "client/playback/source_playback.h"
#include "tests/unit/playback/scripted_source.h"
#include "tests/unit/sound/cranked_out.h"

namespace aucast::app {
namespace {

TEST(SoundSession, ALostDeviceIsThereNoMore) {
  sound::test::Crank crank;
  Notices notices;
  const face::Face face;
  const pipeline::AuMapping mapping{face, {}, {}};
  sound::HeardPlayer player(mapping, playback::Interpolation::Linear);
  SoundSession session(SoundOptions{}, player, notices);
  session.set_out(std::make_unique<sound::test::CrankedOut>(crank));
  EXPECT_TRUE(session.has_device());
  EXPECT_TRUE(session.sound_view().there);

  auto source = std::make_unique<playback::test::ScriptedSource>();
  source->now.voice = true;
  playback::SourcePlayback played(std::move(source), playback::SourcePlayback::Options{});
  player.open(&played, {});
  session.begin_again();
  Instant now(std::chrono::hours(1));
  player.advance(now, [](const auto&, Instant) {});
  session.advanced(now);
  ASSERT_TRUE(player.sound().sounds());
  EXPECT_TRUE(session.has_device());

  crank.lost = true;
  now += std::chrono::milliseconds(10);
  player.advance(now, [](const auto&, Instant) {});
  session.advanced(now);
  EXPECT_FALSE(session.has_device());
  EXPECT_FALSE(session.sound_view().there);
  EXPECT_TRUE(session.sound_view().missed);
  EXPECT_EQ(notices.view().text, "the sound device plays no more");

  session.set_out(std::make_unique<sound::test::CrankedOut>(crank));
  EXPECT_TRUE(session.has_device());
  EXPECT_FALSE(session.sound_view().missed);
}

TEST(SoundSession, ADeviceIsMissedUnlessNoSoundIsWanted) {
  Notices notices;
  const face::Face face;
  const pipeline::AuMapping mapping{face, {}, {}};
  sound::HeardPlayer player(mapping, playback::Interpolation::Linear);
  SoundOptions options;
  SoundSession wanting(options, player, notices);
  wanting.set_out(nullptr);
  EXPECT_TRUE(wanting.sound_view().missed);
  options.none = true;
  SoundSession silent(options, player, notices);
  silent.set_out(nullptr);
  EXPECT_FALSE(silent.sound_view().missed);
}

}  // namespace
}  // namespace aucast::app
