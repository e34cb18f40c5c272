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

TEST(StreamList, NamesComeInTheServersOrder) {
  ScriptedServer server({Accept{}, Expect{"{streams}"}, Send{"{streams talk b-2 A.1}", 1}});
  const auto names = list_streams(options_to(server));
  ASSERT_TRUE(names) << names.error().message;
  EXPECT_EQ(*names, (std::vector<std::string>{"talk", "b-2", "A.1"}));
  EXPECT_EQ(server.finish(), "");
}

TEST(StreamList, TokenIsShown) {
  ScriptedServer server({Accept{}, Expect{"{streams token=secret}"}, Send{"{streams talk}"}});
  RemoteOptions options = options_to(server);
  options.security.token = "secret";
  EXPECT_TRUE(list_streams(options));
  EXPECT_EQ(server.finish(), "");
}

TEST(StreamList, RefusalIsSaidAndHarmless) {
  EXPECT_TRUE(has(failure({Accept{}, Expect{"{streams}"}, Send{"{error 401 a token is needed}"}}),
                  "refused: 401 a token is needed"));
  EXPECT_NE(failure({Accept{}, Send{"{error 401 \x1b[31m}"}}), "");
}

TEST(StreamList, OtherAnswersAreNoList) {
  EXPECT_TRUE(has(failure({Accept{}, Send{"{1,2}"}}), "classic server"));
  EXPECT_TRUE(has(failure({Accept{}, Send{"HTTP/1.1 400"}}), "is it an au-transmitter?"));
  EXPECT_TRUE(has(failure({Accept{}, Expect{"{streams}"}, Close{}}), "ended the connection"));
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

}  // namespace
}  // namespace aucast::net
