#include "server/live/served_replay.h"

#include <gtest/gtest.h>

#include <string>

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using protocol::Keyframe;

constexpr Instant kBegin{100s};
constexpr int kKeyframes = 250;

/// Ten seconds of a lively face.
std::shared_ptr<const protocol::EncodedStream> face() {
  std::vector<Keyframe> keyframes;
  for (int i = 0; i < kKeyframes; ++i) {
    Keyframe keyframe;
    for (int au = 1; au <= 17; ++au) {
      keyframe.terms.push_back({static_cast<std::uint8_t>(au), Side::Both,
                                static_cast<std::uint8_t>(10 + (7 * i + au) % 90)});
    }
    keyframe.time_ms = 40;
    keyframes.push_back(keyframe);
  }
  return std::make_shared<const protocol::EncodedStream>(
      protocol::encode_stream(keyframes, 250, 20));
}

/// A packet of 75 bytes for each 60 ms of them.
std::shared_ptr<const protocol::SpokenTrack> voice() {
  const std::string opus = "\x58" + std::string(74, 'x');
  auto track = std::make_shared<protocol::EncodedTrack>();
  for (Milliseconds at{0}; at < 10s; at += 60ms) track->add({at, opus});
  track->finish();
  protocol::SpokenTrack spoken;
  spoken.voice = std::move(track);
  return std::make_shared<const protocol::SpokenTrack>(std::move(spoken));
}

struct Sent {
  int keyframes = 0;
  Milliseconds face{0};
  std::uint64_t voice = 0;
};

Sent replayed(std::shared_ptr<const protocol::SpokenTrack> spoken, const LinkLimits& link) {
  ServedReplay replay(face(), false, kBegin, std::move(spoken), {link, 250, 20});
  Sent sent;
  std::optional<std::uint64_t> last;
  for (Milliseconds at{0}; at <= 11s; at += 5ms) {
    if (!replay.advance(kBegin + at)) continue;
    const protocol::LiveChannel& channel = replay.channel();
    while (channel.voice().find(sent.voice) != nullptr) ++sent.voice;
    for (const protocol::LiveMoment& moment : channel.latest()) {
      if (last && moment.number <= *last) continue;
      last = moment.number;
      ++sent.keyframes;
      EXPECT_EQ(moment.begin, sent.face) << "both clocks stay one";
      sent.face += moment.time;
    }
  }
  EXPECT_TRUE(replay.channel().ended());
  return sent;
}

TEST(ServedReplay, ThinsTheFaceBesideAVoiceOnALinkWithALimit) {
  const Sent sent = replayed(voice(), {24, 180ms, 14, 60ms});
  EXPECT_EQ(sent.face, 10s) << "no time is lost with what is merged";
  EXPECT_EQ(sent.voice, 167U) << "all of the voice";
  EXPECT_LT(sent.keyframes, kKeyframes / 2);
  EXPECT_GT(sent.keyframes, 20);
}

TEST(ServedReplay, NoKeyframeTakesMoreThanAnHourHoweverLongTheProcessStoodStill) {
  ServedReplay replay(face(), true, kBegin, voice(), {{24, 180ms, 14, 60ms}, 250, 20});
  static_cast<void>(replay.advance(kBegin + 1s));
  for (Milliseconds at = 2h + 30min; at < 2h + 30min + 3s; at += 5ms) {
    static_cast<void>(replay.advance(kBegin + at));
    const protocol::LiveMoment* const newest = replay.channel().newest();
    EXPECT_LE(newest == nullptr ? 0ms : newest->time, 1h);
  }
  const protocol::LiveMoment& sent = *replay.channel().newest();
  const protocol::LiveMoment& begun = *replay.replay().newest();
  EXPECT_LE(sent.begin + sent.time, begun.begin + begun.time);
  EXPECT_GE(sent.begin + sent.time, begun.begin - 1s) << "both clocks agree";
}

TEST(ServedReplay, WithoutALimitOrAVoiceSendsTheStreamAsItIs) {
  EXPECT_EQ(replayed(voice(), {}).keyframes, kKeyframes);
  EXPECT_EQ(replayed(nullptr, {24, 180ms, 14, 60ms}).keyframes, kKeyframes);
}

}  // namespace
}  // namespace aucast::server
