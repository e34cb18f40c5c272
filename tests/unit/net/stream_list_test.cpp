#include "client/net/stream_list.h"

#include <gtest/gtest.h>

#include "tests/support/scripted_server.h"

namespace aucast::net {
namespace {

using namespace test;

RemoteOptions options_to(const ScriptedServer& server) {
  RemoteOptions options;
  options.host = "127.0.0.1";
  options.port = server.port();
  return options;
}

std::string failure(std::vector<Step> steps, Duration patience = std::chrono::seconds(20)) {
  ScriptedServer server(std::move(steps));
  RemoteOptions options = options_to(server);
  options.connect_timeout = patience;
  const auto names = list_streams(options);
  if (names) return "";
  EXPECT_EQ(names.error().kind, ErrorKind::Network);
  EXPECT_TRUE(names.error().message.starts_with("127.0.0.1:" + std::to_string(server.port())));
  EXPECT_EQ(names.error().message.find('\x1b'), std::string::npos);
  return names.error().message;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<protocol::ListedStream> answered(const std::string& packet) {
  ScriptedServer server({Accept{}, Expect{"{streams details=1}"}, Send{packet, 1}});
  const auto list = list_streams(options_to(server));
  EXPECT_TRUE(list) << list.error().message;
  EXPECT_EQ(server.finish(), "");
  return list ? list->streams : std::vector<protocol::ListedStream>{};
}

TEST(StreamList, NamesOfAnOlderServerComeInItsOrder) {
  EXPECT_EQ(answered("{streams talk b-2 A.1}"),
            (std::vector<protocol::ListedStream>{{"talk"}, {"b-2"}, {"A.1"}}));
}

TEST(StreamList, WhatTheServerSaysOfItsStreamsComesToo) {
  EXPECT_EQ(answered("{streams stream=talk live=0 duration=83000 title=QSB0YWxr stream=b}"),
            (std::vector<protocol::ListedStream>{{"talk", false, 83'000, "A talk"}, {"b"}}));
}

TEST(StreamList, TokenIsShown) {
  ScriptedServer server(
      {Accept{}, Expect{"{streams token=secret details=1}"}, Send{"{streams talk}"}});
  RemoteOptions options = options_to(server);
  options.security.token = "secret";
  EXPECT_TRUE(list_streams(options));
  EXPECT_EQ(server.finish(), "");
}

TEST(StreamList, RefusalIsSaidAndHarmless) {
  EXPECT_TRUE(
      has(failure({Accept{}, Expect{"{streams details=1}"}, Send{"{error 401 a token is needed}"}}),
          "refused: 401 a token is needed"));
  EXPECT_NE(failure({Accept{}, Send{"{error 401 \x1b[31m}"}}), "");
}

TEST(StreamList, OtherAnswersAreNoList) {
  EXPECT_TRUE(has(failure({Accept{}, Send{"{1,2}"}}), "classic server"));
  EXPECT_TRUE(has(failure({Accept{}, Send{"HTTP/1.1 400"}}), "is it an au-transmitter?"));
  EXPECT_TRUE(
      has(failure({Accept{}, Expect{"{streams details=1}"}, Close{}}), "ended the connection"));
  EXPECT_TRUE(has(failure({Accept{}, Send{"{streams stream=a live=2}"}}), "live is a number"));
  EXPECT_TRUE(has(failure({Accept{}}, std::chrono::milliseconds(200)), "no answer in time"));
}

TEST(StreamList, ServerThatIsNotThereIsSaid) {
  RemoteOptions options;
  options.host = "127.0.0.1";
  options.port = 1;
  const auto names = list_streams(options);
  ASSERT_FALSE(names);
  EXPECT_EQ(names.error().kind, ErrorKind::Network);
  EXPECT_TRUE(has(names.error().message, "cannot be reached: Connection refused"));
}

TEST(StreamList, TheNextOfSeveralServersIsAskedWhenOneIsNotThere) {
  ScriptedServer server({Accept{}, Expect{"{streams details=1}"}, Send{"{streams talk}"}});
  RemoteOptions options;
  options.host = "127.0.0.1";
  options.port = 1;
  options.others = {{"127.0.0.1", server.port()}};
  const auto list = list_streams(options);
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_EQ(list->streams, std::vector<protocol::ListedStream>{{"talk"}});

  options.others = {{"127.0.0.1", 2}};
  const auto none = list_streams(options);
  ASSERT_FALSE(none);
  EXPECT_TRUE(has(none.error().message, "127.0.0.1:1: cannot be reached"));
  EXPECT_TRUE(has(none.error().message, "\n127.0.0.1:2: cannot be reached"));
}

TEST(StreamList, AllServersTogetherHaveTheTime) {
  ScriptedServer first({Accept{}});
  ScriptedServer second({Accept{}});
  RemoteOptions options;
  options.host = "127.0.0.1";
  options.port = first.port();
  options.others = {{"127.0.0.1", second.port()}};
  const auto begun = std::chrono::steady_clock::now();
  const auto none = list_streams(options, std::chrono::milliseconds(200));
  EXPECT_LT(std::chrono::steady_clock::now() - begun, options.connect_timeout);
  ASSERT_FALSE(none);
  for (const ScriptedServer* silent : {&first, &second}) {
    const std::string server = "127.0.0.1:" + std::to_string(silent->port());
    EXPECT_TRUE(has(none.error().message, server + ": no answer in time")) << none.error().message;
  }
}

}  // namespace
}  // namespace aucast::net
