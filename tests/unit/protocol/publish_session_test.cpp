#include "protocol/publish_session.h"

#include <gtest/gtest.h>

#include <string>

namespace aucast::protocol {
namespace {

using Answer = PublishSession::Answer;

PublishSession publisher() {
  return PublishSession({"talk", "word", "4f1c"});
}

/// All at once, and byte by byte.
std::string reason_of(const std::string& bytes) {
  PublishSession whole = publisher();
  const Answer answer = whole.on_bytes(bytes);
  const auto* failed = std::get_if<PublishSession::Failed>(&answer);
  PublishSession cut = publisher();
  Answer last;
  for (std::size_t i = 0; i < bytes.size() && last.index() == 0; ++i) {
    last = cut.on_bytes(bytes.substr(i, 1));
  }
  EXPECT_EQ(last.index(), answer.index()) << bytes;
  return failed == nullptr ? "" : failed->reason;
}

TEST(PublishSession, SaysWhatItBrings) {
  EXPECT_EQ(publisher().hello(), "{hello v=2 window=1 token=word relay=4f1c publish=talk}");
}

TEST(PublishSession, HandsOnAllThatHasComeWhenItIsTaken) {
  PublishSession session = publisher();
  EXPECT_EQ(session.on_bytes(" {hello v=2 window=8").index(), 0U);
  const Answer answer = session.on_bytes(" stream=talk takes=1}1");
  const auto* taken = std::get_if<PublishSession::Taken>(&answer);
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(taken->bytes, " {hello v=2 window=8 stream=talk takes=1}1");
}

TEST(PublishSession, SaysWhyItIsNotTaken) {
  EXPECT_EQ(reason_of("{error 409 another publisher sends it}"),
            "the server refused: 409 another publisher sends it");
  EXPECT_EQ(reason_of("{hello v=2 window=1 stream=six keyframe=250}").substr(0, 19),
            "it takes no streams")
      << "one that never heard of publishers";
  EXPECT_EQ(reason_of("{hello v=2 window=8 stream=talk}").substr(0, 19), "it takes no streams");
  EXPECT_EQ(reason_of("{streams talk}").substr(0, 19), "it takes no streams");
  EXPECT_EQ(reason_of("{1,6}"), "it speaks classic only, and takes no streams");
  EXPECT_NE(reason_of("HTTP/1.1 400 Bad Request").find("not the protocol"), std::string::npos);
  EXPECT_NE(reason_of("1").find("takes no streams"), std::string::npos) << "a client";
}

TEST(PublishSession, KeepsNoMoreThanAHello) {
  const std::string reason = reason_of("{hello " + std::string(100'000, 'x'));
  EXPECT_NE(reason.find("not the protocol: no closing brace"), std::string::npos) << reason;
}

}  // namespace
}  // namespace aucast::protocol
