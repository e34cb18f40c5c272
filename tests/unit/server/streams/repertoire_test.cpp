#include "server/streams/repertoire.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using test::TempFolder;

constexpr const char* kTalk = "Beg_Stream\n1:10,12:80;40\n6,12\nEnd_Stream\n";

TEST(MakeRepertoire, EncodesEveryStreamForBothLevels) {
  const TempFolder folder;
  const auto sources = load_sources({folder.write("talk.txt", kTalk)}, {}, {100});
  ASSERT_TRUE(sources);
  const auto catalogue = make_repertoire(*sources, 100, false).catalogue;
  EXPECT_EQ(catalogue.keyframe_ms, 100U);
  EXPECT_FALSE(catalogue.loop);
  ASSERT_EQ(catalogue.streams.size(), 1U);
  EXPECT_EQ(catalogue.streams[0].name, "talk");
  EXPECT_EQ(catalogue.streams[0].live(), nullptr);
  const auto& stream = *catalogue.streams[0].recorded()->encoded;
  EXPECT_EQ(stream.classic, (protocol::PacketList{"{12}", "{6,12}"}));
  EXPECT_EQ(stream.negotiated, (protocol::PacketList{"{1:10,12:80;40}", "{6,12}"}));
  EXPECT_EQ(stream.duration_ms, 140U);
}

TEST(MakeRepertoire, HasTheTimesAndTheChangesForWhoAsks) {
  const TempFolder folder;
  const auto sources = load_sources(
      {folder.write("a.txt", "Beg_Stream\n1:10,12:80;40\n1:10,12:70\n14;0\nEnd_Stream\n")}, {},
      {300, 20});
  ASSERT_TRUE(sources);
  const auto catalogue = make_repertoire(*sources, 300, false).catalogue;
  const auto& stream = *catalogue.streams.front().recorded()->encoded;
  EXPECT_EQ(stream.times, (std::vector<protocol::KeyframeTime>{protocol::KeyframeTime(40),
                                                               protocol::KeyframeTime(300),
                                                               protocol::KeyframeTime(0)}));
  EXPECT_EQ(stream.changes, (protocol::PacketList{"{1:10,12:80;40}", "{~12:70}", "{14;0}"}));
}

TEST(MakeRepertoire, LeavesPlainSetsAsTheThesisHasThem) {
  const TempFolder folder;
  const auto sources =
      load_sources({folder.write("a.txt", "Beg_Stream\n1,6,12,14\n6,12\nEnd_Stream\n")});
  ASSERT_TRUE(sources);
  EXPECT_TRUE(make_repertoire(*sources, 250, false)
                  .catalogue.streams.front()
                  .recorded()
                  ->encoded->changes.empty());
}

TEST(CheckLive, RefusesOnlyALoopWithoutTime) {
  const TempFolder folder;
  const auto sources =
      load_sources({folder.write("a.txt", kTalk),
                    folder.write("still.txt", "Beg_Stream\n1;0\n2;0\nEnd_Stream\n")});
  ASSERT_TRUE(sources);
  EXPECT_TRUE(check_live(make_repertoire(*sources, 250, false).catalogue));
  const auto refused = check_live(make_repertoire(*sources, 250, true).catalogue);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::BadData);
  EXPECT_NE(refused.error().message.find("the stream 'still' takes no time at all"),
            std::string::npos);
}

TEST(HeldBackFor, IsSomeTimesWorthOfTheBusiestStream) {
  const TempFolder folder;
  const auto slow = folder.write("slow.txt", "Beg_Stream\n1;500\n2;500\nEnd_Stream\n");
  const auto busy = folder.write("busy.txt", "Beg_Stream\n1;1\n2;1\nEnd_Stream\n");
  const auto of = [](const std::vector<std::filesystem::path>& paths) {
    return held_back_for(make_repertoire(*load_sources(paths), 250, false).catalogue, {});
  };
  EXPECT_EQ(of({slow}), 512) << "the least";
  EXPECT_EQ(of({slow, busy}), 5 * protocol::kLiveWindowTime.count() / 2) << "{1;1} each";
}

}  // namespace
}  // namespace aucast::server
