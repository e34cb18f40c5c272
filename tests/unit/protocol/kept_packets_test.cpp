// What holds packets for sessions: lists, the last of many, and a voice that grows.

#include <gtest/gtest.h>

#include <string>

#include "protocol/encoded_track.h"
#include "protocol/packet_list.h"
#include "protocol/recent.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::protocol {
namespace {

const std::string kTwentyMs("\x08", 1);  ///< an Opus packet (RFC 6716 table 2: SILK, 20 ms)

TEST(PacketList, GivesEachPacketAsItWasAdded) {
  PacketList list = test::packets({"{1}", "", "{12:40;33}"});
  EXPECT_EQ(list.size(), 3U);
  EXPECT_EQ(list.bytes(), 13U);
  EXPECT_EQ(list[0], "{1}");
  EXPECT_EQ(list[1], "");
  EXPECT_EQ(list[2], "{12:40;33}");
  list.push_back("{0}");
  EXPECT_EQ(list[3], "{0}");
  EXPECT_FALSE(list.empty());
  EXPECT_TRUE(PacketList().empty());
  EXPECT_NE(test::packets({"{1}", "{2}"}), test::packets({"{1}{2}"})) << "where they end counts";
}

TEST(Recent, CountsOnWhenTheOldestAreDropped) {
  Recent<std::string> recent;
  EXPECT_TRUE(recent.empty());
  EXPECT_EQ(recent.find(0), nullptr);
  for (const char* word : {"a", "b", "c"}) recent.push_back(word);
  recent.pop_front();
  EXPECT_EQ(recent.first_number(), 1U);
  EXPECT_EQ(recent.find(0), nullptr) << "dropped";
  ASSERT_NE(recent.find(1), nullptr);
  EXPECT_EQ(*recent.find(1), recent.front());
  EXPECT_EQ(*recent.find(2), recent.back());
  EXPECT_EQ(recent.find(3), nullptr) << "still to come";
  EXPECT_EQ(recent.find(UINT64_MAX), nullptr);
  recent.pop_front();
  recent.pop_front();
  recent.push_back("d");
  EXPECT_EQ(*recent.find(3), "d");
}

TEST(EncodedTrack, GrowsUntilItIsFinished) {
  EncodedTrack track;
  EXPECT_EQ(track.encoded_until(), Milliseconds(0));
  track.add({Milliseconds(0), kTwentyMs});
  EXPECT_EQ(track.encoded_until(), Milliseconds(20));
  track.encoded_to(Milliseconds(10));
  EXPECT_EQ(track.encoded_until(), Milliseconds(20)) << "it never falls";
  track.encoded_to(Milliseconds(500));
  track.add({Milliseconds(500), kTwentyMs});
  EXPECT_EQ(track.encoded_until(), Milliseconds(520)) << "a pause was encoded, too";
  EXPECT_FALSE(track.complete());
  track.finish();
  EXPECT_TRUE(track.complete());
  ASSERT_EQ(track.packets().size(), 2U);
  EXPECT_EQ(track.packets()[1].begin, Milliseconds(500));
  EXPECT_EQ(track.packets()[1].end, Milliseconds(520));
  EXPECT_EQ(track.packets()[1].continued, "{a CA}");
  EXPECT_EQ(track.bytes(), 2 * (sizeof(EncodedVoice) + 6));
}

TEST(SpokenTrack, IsTheSameWhenClientsWouldHearAndReadTheSame) {
  const auto voice = std::make_shared<const EncodedTrack>();
  const auto one = std::make_shared<const SpokenTrack>(SpokenTrack{voice, {{0, "a"}}, false});
  const auto like = std::make_shared<const SpokenTrack>(SpokenTrack{voice, {{0, "a"}}, false});
  const auto silent = std::make_shared<const SpokenTrack>(SpokenTrack{nullptr, {{0, "a"}}, false});
  const auto other = std::make_shared<const SpokenTrack>(SpokenTrack{voice, {{0, "b"}}, false});
  EXPECT_TRUE(same_spoken(one, like));
  EXPECT_FALSE(same_spoken(one, silent));
  EXPECT_FALSE(same_spoken(one, other));
  EXPECT_FALSE(same_spoken(one, nullptr));
  EXPECT_TRUE(same_spoken(nullptr, nullptr));
  EXPECT_TRUE(one->has_captions());
  EXPECT_FALSE(SpokenTrack{}.has_captions());
  EXPECT_TRUE((SpokenTrack{nullptr, {}, true}).has_captions()) << "some may come";
}

}  // namespace
}  // namespace aucast::protocol
