#include "client/app/window/files/export_session.h"

#include <future>
#include <stdexcept>
#include <stop_token>

#include <gtest/gtest.h>

#include "client/app/window/files/au_table.h"
#include "common/files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::app {
namespace {

playback::Keyframe keyframe(std::initializer_list<AuTerm> terms, int ms) {
  playback::Keyframe timed{frame_from_terms({terms.begin(), terms.size()}), std::nullopt};
  if (ms >= 0) timed.time = Milliseconds(ms);
  return timed;
}

Result<std::string> outcome_of(ExportSession& session) {
  session.wait();
  auto outcome = session.advance();
  return outcome ? *std::move(outcome) : Error{ErrorKind::Failed, "nothing was begun"};
}

TEST(AuTable, HasARowForEachKeyframeAndAColumnForEachAuThatOccurs) {
  const std::vector<playback::Keyframe> keyframes = {
      keyframe({{12, Side::Both, 80}}, 500),
      keyframe({{12, Side::Both, 5}, {14, Side::Left, 100}}, -1), keyframe({}, 40)};
  EXPECT_EQ(format_au_table(keyframes, Milliseconds(250)),
            "time_s,duration_s,AU12,AU14_left,AU14_right\n"
            "0.500,0.500,80,0,0\n"
            "0.750,0.250,5,100,0\n"
            "0.790,0.040,0,0,0\n");
  EXPECT_EQ(format_au_table({}, Milliseconds(250)), "time_s,duration_s\n");
}

TEST(ExportSession, WritesTableStreamAndMesh) {
  const test::TempFolder folder;
  EXPECT_FALSE(ExportSession::table({}, folder.path() / "none.csv"));
  const Played one = {{keyframe({{12, Side::Both, 80}}, 500)}, 1};
  const auto table = ExportSession::table(one, folder.path() / "a.csv");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(folder.read("a.csv"), "time_s,duration_s,AU12\n0.500,0.500,80\n");
  EXPECT_EQ(*table, "1 keyframe as a table in " + (folder.path() / "a.csv").string());
  const auto stream = ExportSession::stream(one, folder.path() / "a.txt");
  ASSERT_TRUE(stream) << stream.error().message;
  EXPECT_EQ(folder.read("a.txt"), "Beg_Stream\n12:80;500\nEnd_Stream\n");
  const face::Face face = face::test::small_face();
  ASSERT_TRUE(ExportSession::mesh(face, face::test::only(face, "jaw", 2), folder.path() / "a.obj"));
  ASSERT_TRUE(ExportSession::mesh(face, face::test::only(face, "jaw", 0), folder.path() / "b.obj"));
  EXPECT_NE(folder.read("a.obj").find("\nf "), std::string::npos);
  EXPECT_NE(folder.read("a.obj"), folder.read("b.obj")) << "as it is shown";
}

TEST(ExportSession, ATableHasTheTimesAtWhichFacesWereSeen) {
  const test::TempFolder folder;
  const Played slow = {
      {keyframe({{12, Side::Both, 80}}, -1), keyframe({}, 40)}, 2, Milliseconds(1000)};
  ASSERT_TRUE(ExportSession::table(slow, folder.path() / "a.csv"));
  EXPECT_EQ(folder.read("a.csv"), "time_s,duration_s,AU12\n1.000,1.000,80\n1.040,0.040,0\n");
}

TEST(Played, KeepsNoMoreThanAnHourAndCountsAll) {
  Played played;
  for (std::size_t i = 0; i < Played::kKept + 1; ++i) played.add(keyframe({}, 1));
  EXPECT_EQ(played.keyframes.size(), Played::kKept);
  EXPECT_EQ(played.begun, Played::kKept + 1);
}

TEST(ExportSession, SaysHowMuchIsMissing) {
  const test::TempFolder folder;
  const Played all{{keyframe({}, 1)}, 1};
  const Played first{{keyframe({}, 1)}, 2};
  const std::string cut = "only the first";
  const auto whole = ExportSession::table(all, folder.path() / "a.csv");
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->find(cut), std::string::npos) << *whole;
  const auto table = ExportSession::table(first, folder.path() / "a.csv");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_NE(table->find(cut + " 1 of 2 keyframes"), std::string::npos) << *table;
  const auto stream = ExportSession::stream(first, folder.path() / "a.txt");
  ASSERT_TRUE(stream) << stream.error().message;
  EXPECT_NE(stream->find(cut + " 1 of 2 keyframes"), std::string::npos) << *stream;
}

TEST(ExportSession, AGlbFileIsWrittenInTheBackgroundOneAtATime) {
  std::promise<void> may_end;
  std::shared_future<void> end = may_end.get_future().share();
  ExportSession session([end](const PlayerOptions& options, const auto& keyframes,
                              const std::string& name,
                              BackgroundWork::Course& course) -> Result<std::string> {
    course.reached(1, 4);
    end.wait();
    return options.exported.glb().string() + " " + name + " " + std::to_string(keyframes.size());
  });
  const Played one = {{keyframe({{12, Side::Both, 80}}, 500)}, 3};
  ASSERT_TRUE(session.glb({}, one, "talk", "/x/talk.glb"));
  EXPECT_EQ(session.view().file, "/x/talk.glb");
  const auto second = session.glb({}, one, "talk", "/x/other.glb");
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("still being written"), std::string::npos);
  may_end.set_value();
  const auto outcome = outcome_of(session);
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->starts_with("/x/talk.glb talk 1\nonly the first 1 of 3 keyframes"))
      << *outcome;
  EXPECT_EQ(session.view(), gui::ExportView{});
}

TEST(ExportSession, AGlbFileCanBeCancelled) {
  std::promise<void> begun;
  ExportSession session([&begun](const PlayerOptions&, const auto&, const std::string&,
                                 BackgroundWork::Course& course) -> Result<std::string> {
    course.reached(1, 4);
    begun.set_value();
    std::promise<void> cancelled;
    const std::stop_callback on_cancel(course.stop(), [&cancelled] { cancelled.set_value(); });
    cancelled.get_future().wait();
    return Error{ErrorKind::Failed, "stopped"};
  });
  ASSERT_TRUE(session.glb({}, {}, "talk", "/x/talk.glb"));
  begun.get_future().wait();
  EXPECT_EQ(session.view().percent, 25);
  EXPECT_FALSE(session.view().ending);
  session.cancel();
  EXPECT_TRUE(session.view().ending || session.view().file.empty());
  const auto outcome = outcome_of(session);
  ASSERT_TRUE(outcome) << "the user wanted it";
  EXPECT_EQ(*outcome, "cancelled: /x/talk.glb was not written");
}

TEST(ExportSession, WhatIsThrownInTheBackgroundIsAFailure) {
  ExportSession session(
      [](const PlayerOptions&, const auto&, const std::string&,
         BackgroundWork::Course&) -> Result<std::string> { throw std::length_error("too long"); });
  ASSERT_TRUE(session.glb({}, {}, "talk", "/x/talk.glb"));
  const auto outcome = outcome_of(session);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().message, "the work broke off (too long); try it again");
}

}  // namespace
}  // namespace aucast::app
