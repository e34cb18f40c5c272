#include "server/streams/repertoire.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::server {
namespace {

using test::TempFolder;

constexpr const char* kTalk = "Beg_Stream\n1:10,12:80;40\n6,12\nEnd_Stream\n";

TEST(MakeRepertoire, EncodesEveryStreamForBothLevels) {
  const TempFolder folder;
  const auto sources = load_sources({folder.write("talk.txt", kTalk)}, {}, {100});
  ASSERT_TRUE(sources);
  const Repertoire repertoire = make_repertoire(*sources);
  ASSERT_EQ(repertoire.size(), 1U);
  EXPECT_EQ(repertoire[0].stream.name, "talk");
  EXPECT_EQ(repertoire[0].stream.live(), nullptr);
  const auto& stream = *repertoire[0].stream.recorded()->encoded;
  EXPECT_EQ(stream.classic, test::packets({"{12}", "{6,12}"}));
  EXPECT_EQ(stream.negotiated, test::packets({"{1:10,12:80;40}", "{6,12}"}));
  EXPECT_EQ(stream.duration_ms, 140U);
}

TEST(MakeRepertoire, HasTheTimesAndTheChangesForWhoAsks) {
  const TempFolder folder;
  const auto sources = load_sources(
      {folder.write("a.txt", "Beg_Stream\n1:10,12:80;40\n1:10,12:70\n14;0\nEnd_Stream\n")}, {},
      {300, 20});
  ASSERT_TRUE(sources);
  const Repertoire repertoire = make_repertoire(*sources);
  const auto& stream = *repertoire.front().stream.recorded()->encoded;
  EXPECT_EQ(stream.times, (std::vector<protocol::KeyframeTime>{protocol::KeyframeTime(40),
                                                               protocol::KeyframeTime(300),
                                                               protocol::KeyframeTime(0)}));
  EXPECT_EQ(stream.changes, test::packets({"{1:10,12:80;40}", "{~12:70}", "{14;0}"}));
}

TEST(MakeRepertoire, LeavesPlainSetsAsTheThesisHasThem) {
  const TempFolder folder;
  const auto sources =
      load_sources({folder.write("a.txt", "Beg_Stream\n1,6,12,14\n6,12\nEnd_Stream\n")});
  ASSERT_TRUE(sources);
  EXPECT_TRUE(make_repertoire(*sources).front().stream.recorded()->encoded->changes.empty());
}

TEST(CheckLiveLoop, RefusesWhatTakesNoTime) {
  const TempFolder folder;
  const auto talk = folder.write("a.txt", kTalk);
  const auto still = folder.write("still.txt", "Beg_Stream\n1;0\n2;0\nEnd_Stream\n");
  EXPECT_TRUE(check_live_loop(make_repertoire(*load_sources({talk}))));
  const auto refused = check_live_loop(make_repertoire(*load_sources({talk, still})));
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
    return held_back_for(make_repertoire(*load_sources(paths)), {});
  };
  EXPECT_EQ(of({slow}), 512) << "the least";
  EXPECT_EQ(of({slow, busy}), 5 * protocol::kLiveWindowTime.count() / 2) << "{1;1} each";
}

}  // namespace
}  // namespace aucast::server
