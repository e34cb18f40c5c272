#include "protocol/joining.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/encoded_stream.h"
#include "protocol/limits.h"
#include "protocol/live_feed.h"

namespace aucast::protocol {
namespace {

class JoiningTest : public ::testing::Test {
 protected:
  JoiningTest() {
    const std::vector<Keyframe> keyframes(1);
    catalogue_.streams = {{"smile", RecordedStream{std::make_shared<const EncodedStream>(
                                        encode_stream(keyframes, 250, 20))}}};
  }

  [[nodiscard]] Joining joining(Admission admission = Admission::Welcome,
                                Silence silence = Silence::Classic) {
    return {catalogue_, admission, {&wrong_, 1}, silence};
  }
  [[nodiscard]] static HelloAsked hello(std::string token, std::string stream = {}) {
    HelloAsked asked;
    asked.token = std::move(token);
    asked.stream = std::move(stream);
    return asked;
  }
  /// The code, and what is peculiar about the refusal; "in" for a stream that is here.
  [[nodiscard]] static std::string text_of(const Joining::Answer& answer) {
    if (const auto* const refusal = std::get_if<Joining::Refusal>(&answer)) {
      return std::to_string(refusal->reply.code) + (refusal->silent ? " silent" : "") +
             (refusal->after > Duration::zero() ? " later" : "");
    }
    if (std::holds_alternative<HandOver>(answer)) return "taken";
    if (std::holds_alternative<StreamList>(answer)) return "list";
    return std::get<StreamChoice>(answer).state == StreamChoice::State::Ready ? "in" : "not yet";
  }

  ServerCatalogue catalogue_;
  WrongTokens wrong_;
  const Instant now_{};
};

TEST_F(JoiningTest, AnybodyIsLetInWhereNoTokenIsNeeded) {
  EXPECT_EQ(text_of(joining().classic(now_)), "in");
  EXPECT_EQ(text_of(joining().hello(hello("any"), now_)), "in");
  EXPECT_EQ(text_of(joining().list({}, now_)), "list");
  EXPECT_EQ(text_of(joining().hello(hello("", "none"), now_)), "404");
}

TEST_F(JoiningTest, AWrongTokenIsAnsweredLaterAndAMissingOneAtOnce) {
  catalogue_.token = "word";
  EXPECT_EQ(text_of(joining().hello(hello("wore"), now_)), "401 later");
  EXPECT_EQ(text_of(joining().list({"wore"}, now_)), "401 later");
  EXPECT_EQ(text_of(joining().hello(hello(""), now_)), "401");
  EXPECT_EQ(text_of(joining().classic(now_)), "401");
  EXPECT_EQ(text_of(joining().hello(hello("word"), now_)), "in");
}

TEST_F(JoiningTest, TheOwnerShowsATokenOfItsOwnAndNobodyElseIsLetInThere) {
  catalogue_.owner_token = "mine";
  for (const char* viewers : {"", "word"}) {
    catalogue_.token = viewers;
    // However many try, the owner is not shut out.
    for (std::size_t i = 0; i <= kWrongTokensMax; ++i) {
      EXPECT_EQ(text_of(joining(Admission::Owner).hello(hello("word"), now_)), "401");
    }
    EXPECT_EQ(text_of(joining(Admission::Owner).hello(hello(""), now_)), "401");
    EXPECT_EQ(text_of(joining(Admission::Owner).list({}, now_)), "401");
    EXPECT_EQ(text_of(joining(Admission::Owner).classic(now_)), "401");
    EXPECT_EQ(text_of(joining(Admission::Owner).hello(hello("mine"), now_)), "in");
    EXPECT_EQ(text_of(joining(Admission::Owner).list({"mine"}, now_)), "list");
  }
  EXPECT_EQ(text_of(joining().hello(hello("mine"), now_)), "401 later");
  catalogue_.owner_token.clear();
  EXPECT_EQ(text_of(joining(Admission::Owner).hello(hello(""), now_)), "401");
}

TEST_F(JoiningTest, WhoGuessesTooOftenIsComparedNoMore) {
  catalogue_.token = "word";
  for (std::size_t i = 0; i < kWrongTokensMax; ++i) {
    EXPECT_EQ(text_of(joining().hello(hello("wore"), now_)), "401 later");
  }
  EXPECT_EQ(text_of(joining().hello(hello("word"), now_)), "503");
}

TEST_F(JoiningTest, WithoutRoomAClassicClientIsClosedWithoutAWord) {
  for (const Admission full : {Admission::Full, Admission::FullAddress}) {
    EXPECT_EQ(text_of(joining(full).classic(now_)), "503 silent");
    EXPECT_EQ(text_of(joining(full).hello(hello(""), now_)), "503");
    EXPECT_EQ(text_of(joining(full).hello(hello("", "none"), now_)), "404") << "room comes last";
    EXPECT_EQ(text_of(joining(full).list({}, now_)), "list") << "which takes no room";
  }
}

TEST_F(JoiningTest, APageSaysHelloAndBringsNothing) {
  HelloAsked brings = hello("push");
  brings.publish = "face";
  catalogue_.publishers =
      std::make_shared<const Publishers>(std::vector<Publishers::Publisher>{{"push", {"face"}}});
  catalogue_.publish_refused = [](const HelloAsked&) { return std::nullopt; };
  EXPECT_EQ(text_of(joining(Admission::Welcome, Silence::Refused).classic(now_)), "400");
  EXPECT_EQ(text_of(joining(Admission::Welcome, Silence::Refused).hello(brings, now_)), "403");
  EXPECT_EQ(text_of(joining().hello(brings, now_)), "taken");
}

TEST_F(JoiningTest, APublishersTokenIsForItsNamesAndForNoViewer) {
  catalogue_.token = "word";
  catalogue_.publishers =
      std::make_shared<const Publishers>(std::vector<Publishers::Publisher>{{"push", {"face"}}});
  catalogue_.publish_refused = [](const HelloAsked&) { return ErrorReply{409, "it is here"}; };
  HelloAsked brings = hello("push");
  brings.publish = "other";
  EXPECT_EQ(text_of(joining().hello(brings, now_)), "403");
  brings.publish = "face";
  EXPECT_EQ(text_of(joining().hello(brings, now_)), "409");
  brings.token = "word";
  EXPECT_EQ(text_of(joining().hello(brings, now_)), "401 later");
  EXPECT_EQ(text_of(joining().hello(hello("push"), now_)), "401 later");
}

TEST_F(JoiningTest, TheListSaysOfEachStreamWhatIsKnown) {
  const std::vector<Keyframe> two(2);
  const auto recorded = std::make_shared<const EncodedStream>(encode_stream(two, 250, 20));
  const auto longer = std::make_shared<const EncodedStream>(encode_stream(two, 400, 20));
  const auto parents = [](std::string name) {
    auto upstream = std::make_shared<UpstreamStream>();
    upstream->name = std::move(name);
    return upstream;
  };
  const auto relayed = parents("relayed");
  relayed->title = "Theirs";
  relayed->content = std::make_shared<const LiveFeed>(40, 20, false, false, 9000);
  const auto turning = parents("turning");
  turning->content = RecordedStream{recorded};
  turning->loop = true;
  catalogue_.streams = {{"talk", RecordedStream{recorded}},
                        {"spoken", RecordedStream{recorded, nullptr, longer}},
                        {"face", std::make_shared<const LiveFeed>(40, 20)},
                        {"", relayed},
                        {"", turning},
                        {"", parents("")},
                        {"late", parents("")}};
  catalogue_.streams.front().title = "A talk";
  const auto list = [this](bool details, bool loop = false) {
    catalogue_.loop = loop;
    return std::get<StreamList>(joining().list({"", details}, now_)).streams;
  };
  EXPECT_EQ(list(true), (std::vector<ListedStream>{{"talk", false, 500, "A talk"},
                                                   {"spoken", false, 800},
                                                   {"face", true},
                                                   {"relayed", true, 9000, "Theirs"},
                                                   {"turning", false},
                                                   {""},
                                                   {"late"}}));
  EXPECT_EQ(list(true, true)[0], (ListedStream{"talk", false, std::nullopt, "A talk"}))
      << "what starts again has no length";
  EXPECT_EQ(list(false),
            (std::vector<ListedStream>{
                {"talk"}, {"spoken"}, {"face"}, {"relayed"}, {"turning"}, {""}, {"late"}}))
      << "who did not ask may not understand";
}

TEST_F(JoiningTest, WhoWaitsIsAskedForNothingAgain) {
  catalogue_.streams.clear();
  catalogue_.patience = Milliseconds(1000);
  EXPECT_EQ(text_of(joining().hello(hello("", "smile"), now_)), "not yet");
  catalogue_.token = "word";
  EXPECT_EQ(text_of(joining().stream_of(hello("", "smile"))), "not yet");
}

}  // namespace
}  // namespace aucast::protocol
