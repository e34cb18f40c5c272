#include "server/status/status.h"

#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aucast::server {
namespace {

Status busy() {
  Status status;
  status.up_seconds = 3725.5;
  status.streams = {"talk", "six"};
  status.clients = 7;
  status.clients_web = 3;
  status.clients_paused = 1;
  status.clients_behind = 2;
  status.connects = 12;
  status.disconnects = {{"finished", 3}, {"timed out", 2}};
  status.totals = {{100, 1500, 4}, 1700};
  status.wrong_tokens = 9;
  status.queue_bytes = 321;
  status.queue_seconds = 0.25;
  return status;
}

TEST(Status, LinesSayWhatMatters) {
  const auto lines = status_lines(busy());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "status: up 1 h 2 min; clients 7, paused 1, behind 2, web 3");
  EXPECT_EQ(
      lines[1],
      "status: came 12, left 5 (3 finished, 2 timed out), closed unheard 0, accept failures 0, "
      "wrong tokens 9");
  EXPECT_EQ(lines[2],
            "status: sent 100 packets, 1700 bytes; merged 4; waiting 321 bytes, the longest 0.25 "
            "s; lag 0.0 s");
  EXPECT_EQ(lines[3], "status: recorded streams: talk six");
  Status heard = busy();
  heard.totals.sent.voice_packets = 50;
  heard.totals.sent.spoken_bytes = 4000;
  EXPECT_EQ(status_lines(heard).back(),
            "status: of that, voice 50 packets; sound and captions 4000 bytes");
  heard.totals.sent.voice_left_out = 7;
  EXPECT_EQ(status_lines(heard).back(),
            "status: of that, voice 50 packets, left out 7; sound and captions 4000 bytes");
  EXPECT_NE(metrics_text(heard).find("\naucast_voice_left_out_total 7\n"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(status_json(heard))["voice_left_out"], 7);
}

TEST(Status, MetricsAreWellFormed) {
  std::istringstream lines(metrics_text(busy()));
  std::set<std::string> typed;
  std::set<std::string> samples;
  std::string family;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# HELP ")) continue;
    if (line.starts_with("# TYPE ")) {
      std::istringstream words(line.substr(7));
      std::string type;
      words >> family >> type;
      EXPECT_TRUE(type == "gauge" || type == "counter") << line;
      EXPECT_TRUE(typed.insert(family).second) << "twice: " << family;
      EXPECT_EQ(type == "counter", family.ends_with("_total")) << line;
      continue;
    }
    EXPECT_EQ(line.substr(0, line.find_first_of("{ ")), family) << "samples follow their type";
    EXPECT_TRUE(samples.insert(line.substr(0, line.rfind(' '))).second) << line;
    std::size_t used = 0;
    const std::string value = line.substr(line.rfind(' ') + 1);
    EXPECT_NO_THROW(static_cast<void>(std::stod(value, &used)));
    EXPECT_EQ(used, value.size()) << line;
  }
  for (const char* line :
       {"\naucast_clients 7.0\n", "\naucast_disconnects_total{reason=\"timed out\"} 2\n",
        "\naucast_packets_total 100\n", "\naucast_bytes_total 1700\n",
        "\naucast_packets_merged_total 4\n", "\naucast_wrong_tokens_total 9\n",
        "\naucast_queue_seconds 0.25\n", "\naucast_lag_seconds 0.0\n",
        "\naucast_build_info{version=\""}) {
    EXPECT_NE(metrics_text(busy()).find(line), std::string::npos) << line;
  }
}

TEST(Status, TwoPushesOfOneNameToOneServerAreOneSample) {
  Status status;
  status.pushes = {{"talk", "a:4650", true, 2, 1}, {"talk", "a:4650", false, 1, 0}};
  const std::string text = metrics_text(status);
  const std::string sample = "\naucast_push_connects_total{stream=\"talk\",server=\"a:4650\"} ";
  const std::size_t first = text.find(sample + "3\n");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_EQ(text.find(sample, first + 1), std::string::npos);
}

TEST(Status, JsonHasTheSameNumbers) {
  const auto status = nlohmann::json::parse(status_json(busy()));
  EXPECT_EQ(status["clients"], 7);
  EXPECT_EQ(status["disconnects"]["timed out"], 2);
  EXPECT_EQ(status["packets"], 100);
  EXPECT_EQ(status["wrong_tokens"], 9);
  EXPECT_EQ(status["streams"], nlohmann::json({"talk", "six"}));
  EXPECT_EQ(status["stopping"], false);
}

TEST(Status, TellsOfStreamsOfOtherServers) {
  Status status;
  status.upstreams = {{"talk", "a:4650", true, 3, 2, 100, 2000, 5}, {"", "", false, 0, 0, 0, 0, 0}};
  const auto lines = status_lines(status);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[4],
            "status: upstream talk from a:4650: connections 3, lost 2, received 100 packets, 2000 "
            "bytes, left out 5 captions");
  EXPECT_NE(lines[5].find(" from nobody: "), std::string::npos) << lines[5];
  const std::string metrics = metrics_text(status);
  EXPECT_NE(metrics.find("\naucast_upstream_receiving{stream=\"talk\"} 1\n"), std::string::npos);
  EXPECT_NE(metrics.find("\naucast_upstream_losses_total{stream=\"talk\"} 2\n"), std::string::npos);
  EXPECT_NE(metrics.find("\naucast_upstream_captions_left_out_total{stream=\"talk\"} 5\n"),
            std::string::npos);
  const auto json = nlohmann::json::parse(status_json(status));
  EXPECT_EQ(json["upstreams"][0]["parent"], "a:4650");
  EXPECT_EQ(json["upstreams"][0]["bytes"], 2000);
  EXPECT_EQ(json["upstreams"][0]["captions_left_out"], 5);
}

TEST(Status, TellsWhatAnEngineBroughtThatWasLeftOut) {
  Status status;
  EXPECT_FALSE(nlohmann::json::parse(status_json(status)).contains("engine"));
  status.engine = {3, 2, 1};
  EXPECT_EQ(status_lines(status).back(),
            "status: NATS: left out 3 messages, 2 batches, 1 questions");
  EXPECT_NE(metrics_text(status).find("\naucast_engine_left_out_total{what=\"batches\"} 2\n"),
            std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(status_json(status))["engine"]["questions_left_out"], 1);
}

}  // namespace
}  // namespace aucast::server
