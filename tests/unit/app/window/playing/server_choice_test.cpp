#include "client/app/window/playing/server_choice.h"

#include <gtest/gtest.h>

#include "client/app/window/settings/window_settings.h"
#include "tests/support/home_variable.h"

namespace aucast::app {
namespace {

TEST(ServerChoice, TheOtherHostsOfAnAddressAreTriedTooWhoeverNamedThem) {
  PlayerOptions options;
  options.playback.endpoint = "one.example";
  options.playback.others = {{"other.example", 4650}};
  const ServerChoice servers(options.playback);
  gui::RemoteSettings form = WindowSettings(options, {}).in_force().remote;
  const auto same = servers.server_of(form, false);
  ASSERT_TRUE(same) << same.error().message;
  EXPECT_EQ(same->others, options.playback.others);
  EXPECT_TRUE(same->reconnect) << "else the other is never tried";
  ASSERT_EQ(gui::take_address("aucast://third.example,fourth.example:7/talk", form), std::nullopt);
  const auto named = servers.server_of(form, false);
  ASSERT_TRUE(named) << named.error().message;
  EXPECT_EQ(named->others, (std::vector<protocol::Endpoint>{{"fourth.example", 7}}));
  EXPECT_TRUE(named->reconnect);
  ASSERT_EQ(gui::take_address("third.example", form), std::nullopt);
  const auto third = servers.server_of(form, false);
  ASSERT_TRUE(third) << third.error().message;
  EXPECT_TRUE(third->others.empty());
  EXPECT_FALSE(third->reconnect);
}

TEST(ServerChoice, TheFormComesBeforeTheCommandLine) {
  PlaybackOptions options;
  options.speed = Milliseconds(40);
  options.buffers.low_delay = true;
  const ServerChoice servers(options);
  gui::RemoteSettings form;
  form.address = "one.example";
  form.port = 7;
  form.buffer = 50;
  form.stream = "talk";
  const auto server = servers.server_of(form, false);
  ASSERT_TRUE(server) << server.error().message;
  EXPECT_EQ(server->host, "one.example");
  EXPECT_EQ(server->port, 7);
  EXPECT_EQ(server->stream, "talk");
  EXPECT_EQ(server->buffers.receiver_capacity, 50U);
  EXPECT_EQ(server->speed, std::nullopt) << "the form says: the server's own";
  EXPECT_FALSE(server->buffers.low_delay) << "nor is it to be live";
}

TEST(ServerChoice, TheFormNamesWhoMustHaveIssuedTheServersCertificate) {
  const PlaybackOptions options;
  const ServerChoice servers(options);
  gui::RemoteSettings form;
  form.authorities_file = "/nowhere/ca.pem";
  EXPECT_TRUE(servers.server_of(form, false)) << "without TLS there is no certificate";
  form.tls = true;
  const auto refused = servers.server_of(form, false);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("/nowhere/ca.pem"), std::string::npos);
}

TEST(ServerChoice, AVoiceIsAskedForWhereItCanBeHeardOrWritten) {
  PlaybackOptions options;
  EXPECT_FALSE(ServerChoice(options).server_of({}, false)->voice);
  EXPECT_TRUE(ServerChoice(options).server_of({}, true)->voice);
  options.voice = true;
  EXPECT_TRUE(ServerChoice(options).server_of({}, false)->voice);
}

TEST(ServerChoice, OnlyAServerThatAnsweredIsKept) {
  const PlaybackOptions options;
  ServerChoice servers(options);
  gui::RemoteSettings kept;
  kept.address = "lecture.example.org";
  servers.set(kept, {"lecture.example.org"});
  gui::RemoteSettings other = kept;
  other.address = "other.example.org";
  other.buffer = 50;
  servers.choose(other);
  EXPECT_EQ(servers.settings(), other) << "it can be corrected";
  EXPECT_EQ(servers.to_keep().address, "lecture.example.org");
  EXPECT_EQ(servers.to_keep().buffer, 50);
  servers.answered();
  EXPECT_EQ(servers.to_keep().address, "other.example.org");
  EXPECT_EQ(servers.recent(),
            (std::vector<std::string>{"other.example.org", "lecture.example.org"}));
}

TEST(ServerChoice, ItsFilesMayBeInTheHomeFolder) {
  const test::HomeVariable home;
  home.folder().write("token", "secret\n");
  const PlaybackOptions options;
  const ServerChoice servers(options);
  gui::RemoteSettings form;
  form.tls = true;
  form.token_file = "~/token";
  const auto server = servers.server_of(form, false);
  ASSERT_TRUE(server) << server.error().message;
  form.authorities_file = "~/ca.pem";
  const auto refused = servers.server_of(form, false);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find(home.in("ca.pem")), std::string::npos);
}

}  // namespace
}  // namespace aucast::app
