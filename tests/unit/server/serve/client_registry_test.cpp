// Who may come in and who is told, without a socket: the test is all the peers and the clock.
#include "server/serve/client_registry.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocol/limits.h"
#include "protocol/live_replay.h"
#include "server/settings/limits.h"
#include "tests/support/fake_link.h"
#include "tests/unit/server/serve/talk_fixture.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using test::FakeLink;

class ClientRegistryTest : public TalkFixture {
 protected:
  ClientRegistry& registry() {
    if (!registry_) registry_.emplace(options_, stats_, [this] { ++times_empty_; });
    return *registry_;
  }
  /// Somebody from there connects; nullptr: no link was opened for them.
  std::shared_ptr<FakeLink> knock(const std::string& address = "10.0.0.1",
                                  ClientRegistry::Way way = ClientRegistry::Way::Tcp) {
    std::shared_ptr<FakeLink> link;
    registry().welcome(
        {asio::ip::make_address(address), 50000}, catalogue_,
        [&link] {
          link = std::make_shared<FakeLink>();
          return link;
        },
        way);
    return link;
  }
  static std::string ask(FakeLink& link, std::string_view bytes) {
    link.say(bytes);
    return link.heard();
  }
  [[nodiscard]] Status status(Instant now = {}) {
    Status status;
    registry().describe(status, now);
    return status;
  }

  TransmitterOptions options_;
  Stats stats_;
  int times_empty_ = 0;
  std::optional<ClientRegistry> registry_;
};

TEST_F(ClientRegistryTest, SaysWhenTheLastHasLeft) {
  const auto first = knock();
  const auto second = knock();
  EXPECT_EQ(registry().size(), 2U);
  first->end({});
  EXPECT_EQ(times_empty_, 0);
  second->end({});
  EXPECT_EQ(times_empty_, 1);
  EXPECT_TRUE(registry().empty());
  EXPECT_EQ(stats_.end_reasons().at("peer gone"), 2U);
}

TEST_F(ClientRegistryTest, WhoIsOneTooManyIsToldSoAndTakesNoPlace) {
  options_.max_clients = 1;
  const auto inside = knock();
  const auto refused = knock();
  EXPECT_TRUE(ask(*refused, "{hello v=2}").starts_with("{error 503 the server is full"));
  inside->end({});
  const auto next = knock();
  EXPECT_TRUE(ask(*next, "{hello v=2}").starts_with("{hello ")) << "the refused one takes no place";
}

TEST_F(ClientRegistryTest, WithoutANumberThereAreAsManyAsThereIsRoomFor) {
  registry_.emplace(
      options_, stats_, [] {}, ClientConnection::OnPublisher(),
      ClientRoom{2 * protocol::kOutputBytesMax, std::nullopt});
  const auto first = knock();
  const auto second = knock();
  EXPECT_TRUE(ask(*second, "{hello v=2}").starts_with("{hello "));
  EXPECT_TRUE(ask(*knock(), "{hello v=2}").starts_with("{error 503 the server is full"));
}

TEST_F(ClientRegistryTest, AnAddressHasItsPlacesBackWhenItsClientsLeave) {
  options_.max_clients_per_address = 1;
  const auto first = knock("10.0.0.1");
  EXPECT_TRUE(ask(*knock("10.0.0.1"), "{hello v=2}").starts_with("{error 503 too many clients"));
  EXPECT_TRUE(ask(*knock("10.0.0.2"), "{hello v=2}").starts_with("{hello "));
  first->end({});
  EXPECT_TRUE(ask(*knock("10.0.0.1"), "{hello v=2}").starts_with("{hello "));
}

TEST_F(ClientRegistryTest, OnlySoManyRefusalsAtATimeAreHeard) {
  options_.max_clients = 1;
  const auto inside = knock();
  std::vector<std::shared_ptr<FakeLink>> refused;
  for (std::size_t i = 0; i < kRefusalsMax; ++i) refused.push_back(knock());
  EXPECT_NE(refused.back(), nullptr);
  EXPECT_EQ(knock(), nullptr);
  EXPECT_EQ(status().connects_unheard, 1U);
  EXPECT_EQ(status().connects, 1U + kRefusalsMax);
  refused.front()->end({});
  EXPECT_NE(knock(), nullptr);
}

TEST_F(ClientRegistryTest, ParallelGuessesOfATokenAreAsManyAsOneAddressMayBeWrong) {
  catalogue_->token = "word";
  std::vector<std::shared_ptr<FakeLink>> guessing;
  for (std::size_t i = 0; i < protocol::kWrongTokensMax; ++i) {
    guessing.push_back(knock());
    EXPECT_EQ(ask(*guessing.back(), "{hello token=wore}"), "");
  }
  guessing.front()->end({});
  EXPECT_TRUE(ask(*knock(), "{hello token=word}").starts_with("{error 503 too many wrong tokens"));
  EXPECT_TRUE(ask(*knock("10.0.0.2"), "{hello token=word}").starts_with("{hello "));
  EXPECT_EQ(status().wrong_tokens, protocol::kWrongTokensMax) << "what was not compared is not one";
}

TEST_F(ClientRegistryTest, WhoComesByWebSocketIsCountedAndNeedsAHello) {
  const auto web = knock("10.0.0.1", ClientRegistry::Way::WebSocket);
  const auto tcp = knock();
  EXPECT_EQ(status().clients, 2U);
  EXPECT_EQ(status().clients_web, 1U);
  web->advance(4s);
  EXPECT_EQ(web->heard(), "") << "classic does not begin";
  EXPECT_TRUE(ask(*web, "{hello v=2}").starts_with("{hello "));
  EXPECT_TRUE(ask(*knock("10.0.0.1", ClientRegistry::Way::WebSocket), "1")
                  .starts_with("{error 400 a hello is needed"));
  EXPECT_EQ(ask(*tcp, "1"), "{1}{2}");
}

TEST_F(ClientRegistryTest, AMomentReachesEverybodyAlthoughSomeLeaveMeanwhile) {
  auto live = std::make_shared<protocol::LiveReplay>(stream_, false, Instant{});
  catalogue_->streams = {{"talk", live}};
  std::vector<std::shared_ptr<FakeLink>> links;
  for (int i = 0; i < 3; ++i) {
    links.push_back(knock());
    EXPECT_TRUE(ask(*links.back(), "{hello v=2 window=0}").starts_with("{hello "));
  }
  links[1]->on_write = [&links] { links[1]->end({link::Ending::Why::Lost, "reset"}); };
  live->advance(Instant{});
  registry().on_moment();
  EXPECT_EQ(links[0]->heard(), "{1}");
  EXPECT_EQ(links[2]->heard(), "{1}");
  EXPECT_EQ(registry().size(), 2U);
}

TEST_F(ClientRegistryTest, EverybodyIsStoppedAndWhoDoesNotGoIsClosed) {
  const auto first = knock();
  const auto second = knock();
  ask(*first, "1");
  registry().stop();
  EXPECT_EQ(first->heard(), "{-2}");
  EXPECT_EQ(second->heard(), "{-2}");
  EXPECT_EQ(registry().size(), 2U) << "until their last words are in";
  registry().abort();
  EXPECT_TRUE(first->closed());
  EXPECT_TRUE(second->closed());
  EXPECT_EQ(times_empty_, 1);
}

TEST_F(ClientRegistryTest, TheStatusCountsWhoIsHereAndWhoWas) {
  const auto gone = knock();
  ask(*gone, "1");
  gone->end({});
  const auto paused = knock();
  ask(*paused, "1-1");
  const auto behind = knock();
  behind->take(0);
  ask(*behind, "1");
  const Status now = status(behind->now() + 2s);
  EXPECT_EQ(now.clients, 2U);
  EXPECT_EQ(now.clients_paused, 1U);
  EXPECT_EQ(now.clients_behind, 1U);
  EXPECT_EQ(now.queue_seconds, 2.0);
  EXPECT_EQ(now.queue_bytes, behind->unsent_bytes());
  EXPECT_EQ(now.connects, 3U);
  EXPECT_EQ(now.disconnects.size(), 1U);
}

TEST_F(ClientRegistryTest, APublisherIsHandedOnAndIsNoClientAnyMore) {
  options_.max_clients = 1;
  catalogue_->publishers = std::make_shared<const protocol::Publishers>(
      std::vector<protocol::Publishers::Publisher>{{"word", {}}});
  catalogue_->publish_refused = [](const auto&) { return std::nullopt; };
  std::shared_ptr<link::Link> handed;
  std::string brought;
  std::string from;
  registry_.emplace(
      options_, stats_, [] {},
      [&](auto link, const protocol::HelloAsked& hello, const std::string& peer) {
        handed = std::move(link);
        brought = hello.publish;
        from = peer;
      });
  const auto viewer = knock();
  const auto publisher = knock();
  EXPECT_EQ(ask(*publisher, "{hello token=word publish=talk}"), "") << "though it is full";
  EXPECT_EQ(handed, publisher);
  EXPECT_FALSE(publisher->closed());
  EXPECT_EQ(brought, "talk");
  EXPECT_EQ(from, "10.0.0.1:50000");
  EXPECT_EQ(registry().size(), 1U);
  EXPECT_EQ(stats_.end_reasons().at("publishes"), 1U);
}

TEST_F(ClientRegistryTest, AServerThatWasDialledIsServedLikeAClientAndCountsAsNone) {
  options_.max_clients = 1;
  const auto link = std::make_shared<FakeLink>();
  std::string why;
  std::uint64_t packets = 0;
  registry().serve("campus:4650", catalogue_, link, "{hello v=2 window=2 stream=talk takes=1}",
                   [&](const ClientRecord& record, const std::string& reason) {
                     why = reason;
                     packets = record.sent.keyframes;
                   });
  EXPECT_EQ(link->heard(), "{hello v=2 window=2 stream=talk keyframe=250}{1}{2}");
  EXPECT_EQ(status().clients, 0U);
  const auto viewer = knock();
  EXPECT_EQ(ask(*viewer, "{hello v=2}"), "{hello v=2 window=1 stream=talk keyframe=250}{1}");
  EXPECT_EQ(ask(*link, "11"), "{3}");
  EXPECT_EQ(ask(*link, "1"), "{-2}");
  link->end({});
  EXPECT_EQ(why, "the stream was sent whole");
  EXPECT_EQ(packets, 3U);
  EXPECT_EQ(registry().size(), 1U);
  EXPECT_EQ(status().connects, 1U) << "the viewer";
  EXPECT_TRUE(status().disconnects.empty());
  EXPECT_EQ(status().totals.sent.keyframes, 4U) << "to both";
  EXPECT_EQ(nlohmann::json::parse(stats_.to_json()).at("clients_total"), 0);
}

TEST_F(ClientRegistryTest, AServerThatWasDialledIsNoneOfTheClientsThatAreBehind) {
  const auto link = std::make_shared<FakeLink>();
  link->take(0);
  registry().serve("campus:4650", catalogue_, link, "{hello v=2}-1",
                   [](const ClientRecord&, const std::string&) {});
  EXPECT_EQ(status().clients_behind, 0U);
  EXPECT_EQ(status().clients_paused, 0U);
  EXPECT_EQ(status(link->now() + 2s).queue_seconds, 2.0);
}

}  // namespace
}  // namespace aucast::server
