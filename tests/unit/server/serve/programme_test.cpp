// What is served, without a socket: the test is whoever reads the sources.
#include "server/serve/programme.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "server/serve/client_connection.h"
#include "tests/support/fake_link.h"
#include "tests/support/kept_log.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/protocol/packets.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

protocol::RecordedStream stream_of(const std::string& packet) {
  protocol::EncodedStream stream;
  stream.classic = stream.negotiated = test::packets({packet, "{2}"});
  stream.times.assign(2, protocol::KeyframeTime(3'600'000));
  return {std::make_shared<const protocol::EncodedStream>(std::move(stream))};
}

Repertoire repertoire_of(const std::vector<protocol::ServedStream>& streams) {
  Repertoire repertoire;
  for (const protocol::ServedStream& stream : streams) repertoire.push_back({stream});
  return repertoire;
}

class ProgrammeTest : public ::testing::Test {
 protected:
  Programme& begin(Repertoire repertoire) {
    programme_.emplace(io_, options_, std::move(repertoire),
                       Programme::Events{[this] { on_moment_(); }, [] {}});
    EXPECT_TRUE(programme_->open_sources());
    programme_->begin();
    return *programme_;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    Status status;
    programme_->describe(status);
    return status.streams;
  }

  const test::QuietLog quiet_;
  const test::TempFolder folder_;
  asio::io_context io_;
  TransmitterOptions options_;
  std::function<void()> on_moment_ = [] {};
  std::optional<Programme> programme_;
};

using Names = std::vector<std::string>;

TEST_F(ProgrammeTest, ServesWhatWasReadUntilItIsOthers) {
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  const auto served = [&programme] {
    return programme.catalogue()->streams[0].recorded()->encoded->classic[0];
  };
  EXPECT_FALSE(programme.take_over(repertoire_of({{"a", stream_of("{1}")}}))) << "the same";
  EXPECT_EQ(served(), "{1}");
  EXPECT_TRUE(programme.take_over(repertoire_of({{"a", stream_of("{4}")}})));
  EXPECT_EQ(served(), "{4}");
}

TEST_F(ProgrammeTest, AStreamThatHoldsWhatItHeldIsHeldOnce) {
  const auto first = stream_of("{1}");
  Programme& programme = begin(repertoire_of({{"a", first}}));
  ASSERT_TRUE(programme.take_over(repertoire_of({{"a", stream_of("{1}")}, {"b", first}})));
  EXPECT_EQ(programme.catalogue()->streams[0].recorded()->encoded, first.encoded);
  EXPECT_EQ(names(), (Names{"a", "b"}));
}

TEST_F(ProgrammeTest, ATokenOutlastsTheStreams) {
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  programme.set_tokens("word", nullptr);
  ASSERT_TRUE(programme.take_over(repertoire_of({{"b", stream_of("{1}")}})));
  EXPECT_EQ(programme.catalogue()->token, "word");
}

TEST_F(ProgrammeTest, ALiveStreamGoesOnWithoutAGapWhenItHoldsWhatItHeld) {
  options_.live = true;
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  const auto live = programme.catalogue()->streams[0].live();
  ASSERT_NE(live, nullptr);
  EXPECT_EQ(programme.catalogue()->streams[0].recorded(), nullptr);
  EXPECT_GT(programme.held_back_max(), 0);
  ASSERT_TRUE(
      programme.take_over(repertoire_of({{"a", stream_of("{1}")}, {"b", stream_of("{4}")}})));
  EXPECT_EQ(programme.catalogue()->streams[0].live(), live);
  EXPECT_NE(programme.catalogue()->streams[1].live(), live);
}

TEST_F(ProgrammeTest, RecordedStreamsMayBeHeldBackAsTheSystemLikes) {
  EXPECT_EQ(begin(repertoire_of({{"a", stream_of("{1}")}})).held_back_max(), 0);
}

TEST_F(ProgrammeTest, ASourceThatIsBeingWrittenHasTheStreamOfItsName) {
  options_.live_source.follow = true;
  options_.sources = {folder_.write("face.txt", "12:50;100\n")};
  Programme& programme = begin(repertoire_of({{"face"}, {"a", stream_of("{1}")}}));
  const auto live = programme.catalogue()->streams[0].live();
  ASSERT_NE(live, nullptr);
  ASSERT_TRUE(test::run_until(io_, [&] { return live->newest() != nullptr; }));
  EXPECT_EQ(live->newest()->full, "{12:50;100}");
  ASSERT_TRUE(programme.take_over(repertoire_of({{"face"}, {"a", stream_of("{4}")}})));
  EXPECT_EQ(programme.catalogue()->streams[0].live(), live) << "a reload leaves it alone";
  EXPECT_TRUE(programme.finish());
}

TEST_F(ProgrammeTest, WhenTheLastFileGoesTheRunningSourceIsServedAlone) {
  options_.live_source.follow = true;
  options_.sources = {folder_.write("face.txt", "12:50;100\n")};
  Programme& programme = begin(repertoire_of({{"face"}, {"a", stream_of("{1}")}}));
  EXPECT_EQ(names(), (Names{"face", "a"}));
  EXPECT_TRUE(programme.take_over(repertoire_of({{"face"}})));
  EXPECT_EQ(names(), Names{"face"});
}

TEST_F(ProgrammeTest, WhenAllFilesHaveNamesOfRunningSourcesTheseAreServedAlone) {
  options_.live_source.follow = true;
  options_.sources = {folder_.write("face.txt", "12:50;100\n")};
  Programme& programme = begin(repertoire_of({{"face"}, {"a", stream_of("{1}")}}));
  const auto live = programme.catalogue()->streams[0].live();
  EXPECT_TRUE(programme.take_over(repertoire_of({{"face", stream_of("{1}")}})));
  EXPECT_EQ(names(), Names{"face"});
  EXPECT_EQ(programme.catalogue()->streams[0].live(), live);
}

TEST_F(ProgrammeTest, TheKeyframeTimeAndTheLoopOutlastAReload) {
  options_.keyframe_ms = 120;
  options_.loop = true;
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  ASSERT_TRUE(programme.take_over(repertoire_of({{"b", stream_of("{4}")}})));
  EXPECT_EQ(programme.catalogue()->keyframe_ms, 120U);
  EXPECT_TRUE(programme.catalogue()->loop);
  EXPECT_EQ(programme.alone("b")->keyframe_ms, 120U);
  EXPECT_TRUE(programme.alone("b")->loop);
}

TEST_F(ProgrammeTest, AStreamThatOnlyBecameALiveSourceIsLeftOut) {
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  EXPECT_FALSE(programme.take_over(repertoire_of({{"face"}}))) << "nothing is left";
  EXPECT_EQ(names(), Names{"a"});
  EXPECT_TRUE(programme.take_over(repertoire_of({{"face"}, {"b", stream_of("{1}")}})));
  EXPECT_EQ(names(), Names{"b"});
}

TEST_F(ProgrammeTest, ASourceThatCannotBeOpenedIsAnError) {
  options_.live_source.follow = true;
  options_.sources = {"-"};
  options_.record = "/nowhere/kept.txt";
  Programme programme(io_, options_, repertoire_of({{"live"}}), {[] {}, [] {}});
  EXPECT_FALSE(programme.open_sources());
}

TEST_F(ProgrammeTest, AStreamIsBroughtToOthersAloneUnderAnotherName) {
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}, {"b", stream_of("{4}")}}));
  const auto alone = programme.alone("b");
  ASSERT_EQ(alone->streams.size(), 1U);
  EXPECT_EQ(alone->streams[0].recorded()->encoded->classic[0], "{4}") << "the one of that name";
  EXPECT_EQ(programme.alone("talk")->streams[0].name, "talk");
  EXPECT_EQ(programme.alone("talk")->streams[0].recorded()->encoded->classic[0], "{1}")
      << "the first";
  EXPECT_EQ(programme.alone("")->streams[0].name, "a");
  EXPECT_TRUE(alone->token.empty()) << "who is dialled shows none";
}

TEST_F(ProgrammeTest, WhatPublishersBringStandsBehindItsOwnStreams) {
  options_.credentials.publishers = "publishers";
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  const auto publish_refused = programme.catalogue()->publish_refused;
  protocol::HelloAsked hello;
  hello.publish = "a";
  ASSERT_TRUE(publish_refused(hello));
  EXPECT_EQ(publish_refused(hello)->code, 409) << "its own";
  hello.publish = "talk";
  EXPECT_FALSE(publish_refused(hello));
  programme.take(std::make_shared<test::FakeLink>(), hello, "campus:1");
  EXPECT_EQ(names(), (Names{"a", "talk"}));
  EXPECT_EQ(publish_refused(hello)->code, 409) << "another publisher's";
  EXPECT_TRUE(programme.take_over(repertoire_of({{"b", stream_of("{1}")}})));
  EXPECT_EQ(names(), (Names{"b", "talk"})) << "a reload leaves it";
  EXPECT_EQ(programme.catalogue()->publish_refused(hello)->code, 409);
  EXPECT_TRUE(programme.take_over(repertoire_of({{"talk", stream_of("{1}")}})));
  EXPECT_EQ(names(), Names{"talk"}) << "now one of its own";
  EXPECT_NE(programme.catalogue()->streams[0].recorded(), nullptr);
}

/// A followed table in which one face is seen, whose stream is cam-0.
class FaceProgrammeTest : public ProgrammeTest {
 protected:
  Programme& begin_with_face(std::vector<protocol::ServedStream> others) {
    options_.live_source.follow = true;
    options_.source.recording.all_faces = true;
    options_.credentials.publishers = "publishers";
    options_.sources = {
        folder_.write("cam.csv", sources::tables::kOpenFace2Header +
                                     sources::tables::openface2_row(1, "0.00", "0,2,0,0,0,0,0"))};
    others.insert(others.begin(), {"cam"});
    return begin(repertoire_of(others));
  }
  [[nodiscard]] bool runs_until_said(const std::string& what) {
    return test::run_until(io_, [&] { return log_.said().find(what) != std::string::npos; });
  }

  const test::KeptLog log_;
};

TEST_F(FaceProgrammeTest, AFaceGetsNoStreamUnderTheNameOfAFile) {
  const Programme& programme = begin_with_face({{"cam-0", stream_of("{1}")}});
  EXPECT_TRUE(runs_until_said("cam.csv: face 0 gets no stream"));
  EXPECT_EQ(names(), (Names{"cam", "cam-0"}));
  EXPECT_NE(programme.catalogue()->streams[1].recorded(), nullptr);
}

TEST_F(FaceProgrammeTest, AFaceTakesItsNameFromAPublisherAndKeepsItOverAReload) {
  Programme& programme = begin_with_face({});
  protocol::HelloAsked hello;
  hello.publish = "cam-0";
  programme.take(std::make_shared<test::FakeLink>(), hello, "campus:1");
  EXPECT_EQ(names(), (Names{"cam", "cam-0"}));
  EXPECT_TRUE(runs_until_said("cam.csv: face 0 is the stream cam-0"));
  EXPECT_EQ(names(), (Names{"cam", "cam-0"}));
  const auto live = programme.catalogue()->streams[1].live();
  ASSERT_NE(live, nullptr);
  EXPECT_FALSE(programme.take_over(repertoire_of({{"cam"}, {"cam-0", stream_of("{1}")}})));
  EXPECT_EQ(names(), (Names{"cam", "cam-0"}));
  EXPECT_EQ(programme.catalogue()->streams[1].live(), live);
  EXPECT_NE(log_.said().find("cam-0: another source has that name now"), std::string::npos);
}

TEST_F(ProgrammeTest, IsLiveWhenAStreamIs) {
  options_.credentials.publishers = "publishers";
  const auto live = [this] {
    Status status;
    programme_->describe(status);
    return status.live;
  };
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  EXPECT_FALSE(live()) << "though publishers may come";
  EXPECT_GT(programme.held_back_max(), 0) << "and who waits for one may be sent a live stream";
  options_.live = true;
  begin(repertoire_of({{"a", stream_of("{1}")}}));
  EXPECT_TRUE(live());
}

/// A viewer that waits for a stream that is not here yet.
class WaitingViewerTest : public ProgrammeTest {
 protected:
  Programme& begin_with_viewer() {
    options_.credentials.publishers = "publishers";
    Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
    viewer_ = std::make_shared<ClientConnection>(link_, programme.catalogue(),
                                                 ClientConnection::Settings{},
                                                 [](const ClientRecord&, const std::string&) {});
    viewer_->start();
    link_->say("{hello v=2 stream=talk}");
    on_moment_ = [this] { viewer_->on_moment(); };
    return programme;
  }

  const std::shared_ptr<test::FakeLink> link_ = std::make_shared<test::FakeLink>();
  std::shared_ptr<ClientConnection> viewer_;
};

TEST_F(WaitingViewerTest, WaitsOnForAPublisherOverAReload) {
  Programme& programme = begin_with_viewer();
  ASSERT_TRUE(programme.take_over(repertoire_of({{"b", stream_of("{4}")}})));
  EXPECT_EQ(link_->heard(), "");
  const auto publisher = std::make_shared<test::FakeLink>();
  protocol::HelloAsked hello;
  hello.publish = "talk";
  programme.take(publisher, hello, "campus:1");
  publisher->say("{hello v=2 window=50 stream=talk live=1}{12C;40}");
  EXPECT_NE(link_->heard().find("{12C;40}"), std::string::npos);
}

TEST_F(WaitingViewerTest, FindsWhatAReloadBrings) {
  Programme& programme = begin_with_viewer();
  ASSERT_TRUE(programme.take_over(repertoire_of({{"talk", stream_of("{4}")}})));
  EXPECT_NE(link_->heard().find("{4}"), std::string::npos);
}

TEST_F(WaitingViewerTest, KeepsTheStreamThatItIsSent) {
  Programme& programme = begin_with_viewer();
  ASSERT_TRUE(programme.take_over(repertoire_of({{"talk", stream_of("{4}")}})));
  ASSERT_TRUE(programme.take_over(repertoire_of({{"talk", stream_of("{5}")}})));
  EXPECT_NE(link_->heard().find("{4}"), std::string::npos);
  link_->say("11");
  EXPECT_EQ(link_->heard(), "{2}{-2}") << "the rest of the stream before";
}

TEST_F(ProgrammeTest, APublisherOfATakenNameHearsThatBeforeThatTheServerStops) {
  options_.credentials.publishers = "publishers";
  Programme& programme = begin(repertoire_of({{"a", stream_of("{1}")}}));
  const auto publish_refused = programme.catalogue()->publish_refused;
  programme.stop();
  protocol::HelloAsked hello;
  hello.publish = "a";
  ASSERT_TRUE(publish_refused(hello));
  EXPECT_EQ(publish_refused(hello)->code, 409) << "the order of PROTOCOL.md";
  hello.publish = "talk";
  ASSERT_TRUE(publish_refused(hello));
  EXPECT_EQ(publish_refused(hello)->code, 503);
}

TEST_F(ProgrammeTest, NeedsNoStreamOfItsOwnWherePublishersBringThem) {
  options_.credentials.publishers = "publishers";
  Programme& programme = begin(repertoire_of({}));
  EXPECT_TRUE(programme.catalogue()->patience);
  EXPECT_FALSE(programme.take_over(repertoire_of({}))) << "still none";
  EXPECT_TRUE(programme.catalogue()->streams.empty());
}

}  // namespace
}  // namespace aucast::server
