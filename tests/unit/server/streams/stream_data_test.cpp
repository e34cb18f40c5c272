// What data/streams promises in its README.
#include <algorithm>
#include <array>
#include <filesystem>

#include <gtest/gtest.h>

#include "common/files.h"
#include "protocol/stream_file.h"
#include "server/streams/repertoire.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::server {
namespace {

std::filesystem::path streams_folder() {
  const auto data = find_data_folder({});
  return data ? *data / "streams" : std::filesystem::path();
}

std::vector<Source> load(const std::string& name) {
  auto sources = load_sources({streams_folder() / (name + ".txt")});
  if (sources) return std::move(*sources);
  ADD_FAILURE() << sources.error().message;
  return {};
}

std::vector<protocol::Keyframe> keyframes_of(const std::string& name) {
  const auto text = read_file(streams_folder() / (name + ".txt"));
  EXPECT_TRUE(text);
  auto stream = protocol::parse_stream_file(text ? *text : "", name);
  EXPECT_TRUE(stream);
  return stream ? std::move(stream->keyframes) : std::vector<protocol::Keyframe>{};
}

std::vector<std::string> classic_packets(const std::string& name) {
  const auto sources = load(name);
  if (sources.empty()) return {};
  std::vector<std::string> packets;
  const Repertoire repertoire = make_repertoire(sources);
  const protocol::PacketList& classic = repertoire.front().stream.recorded()->encoded->classic;
  for (std::size_t i = 0; i < classic.size(); ++i) packets.emplace_back(classic[i]);
  return packets;
}

const std::vector<std::string> kTableThreeTwo = {"{1,2,5,15,16,20,26}", "{1,2,4,5,15,20,26}",
                                                 "{2,4,9,15,17}",       "{2,4,7,9,10,20,26}",
                                                 "{1,6,12,14}",         "{1,4,15,23}"};

TEST(StreamData, SixExpressionsAreThoseOfTheThesis) {
  EXPECT_EQ(classic_packets("six_expressions"), kTableThreeTwo);
  for (const auto& keyframe : keyframes_of("six_expressions")) {
    EXPECT_FALSE(keyframe.time_ms.has_value());
  }
}

TEST(StreamData, SingleExpressionsHaveTheBytesOfTableFiveFive) {
  const std::array<std::pair<const char*, std::size_t>, 6> rows = {{{"surprise", 19},
                                                                    {"fear", 18},
                                                                    {"disgust", 13},
                                                                    {"anger", 18},
                                                                    {"happiness", 11},
                                                                    {"sadness", 11}}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto packets = classic_packets(rows[row].first);
    ASSERT_EQ(packets.size(), 1U) << rows[row].first;
    EXPECT_EQ(packets[0], kTableThreeTwo[row]);
    EXPECT_EQ(packets[0].size(), rows[row].second);
  }
}

TEST(StreamData, PrototypesHaveIntensities) {
  const auto sources = load("six_prototypes");
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(make_repertoire(sources)[0].stream.recorded()->encoded->negotiated,
            test::packets({"{1:80,2:80,5:25,26:80}", "{1:80,2:50,4:50,5:80,20:50,25:50}",
                           "{9:80,16:50,26:25}", "{4:80,5:50,7:80,23:80}", "{6:80,12}",
                           "{1:80,4:50,11:25,15:25}"}));
}

TEST(StreamData, TalkIsLongTimedAndEndsNeutral) {
  const auto keyframes = keyframes_of("talk");
  ASSERT_FALSE(keyframes.empty());
  EXPECT_GE(keyframes.size(), 400U);
  std::array<bool, kAuCount> used{};
  for (const auto& keyframe : keyframes) {
    ASSERT_TRUE(keyframe.time_ms.has_value());
    EXPECT_GE(*keyframe.time_ms, 20U);
    for (const AuTerm& term : keyframe.terms) used[term.number] = true;
  }
  for (const std::size_t number :
       {1U, 2U, 4U, 5U, 6U, 12U, 25U, 26U, 45U, 51U, 52U, 54U, 55U, 61U, 62U, 63U}) {
    EXPECT_TRUE(used[number]) << "AU " << number;
  }
  EXPECT_EQ(frame_from_terms(keyframes.back().terms), AuFrame());
}

TEST(StreamData, LipWipeGoesFromSideToSideAndEndsNeutral) {
  const auto keyframes = keyframes_of("lip_wipe");
  ASSERT_FALSE(keyframes.empty());
  int sides = 0;
  for (const auto& keyframe : keyframes) {
    ASSERT_TRUE(keyframe.time_ms.has_value());
    const AuFrame frame = frame_from_terms(keyframe.terms);
    if (frame.left[37] != frame.right[37]) ++sides;
  }
  EXPECT_EQ(sides, 4);
  EXPECT_EQ(frame_from_terms(keyframes.back().terms), AuFrame());
}

TEST(StreamData, RandomStreamHasAHundredUntimedPackets) {
  const auto sources = load("random");
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].summary.keyframes, 100U);
}

TEST(StreamData, EveryBadFileIsRefusedWithItsPlace) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(streams_folder() / "bad")) {
    SCOPED_TRACE(entry.path());
    const auto sources = load_sources({entry.path()});
    ASSERT_FALSE(sources);
    EXPECT_EQ(sources.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(sources.error().message.starts_with(entry.path().string() + ":"))
        << sources.error().message;
    ++files;
  }
  EXPECT_GE(files, 16U);
}

}  // namespace
}  // namespace aucast::server
