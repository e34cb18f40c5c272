#include "server/status/stats.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

ClientRecord record(std::uint64_t number) {
  return {number, "127.0.0.1:5000", 1, "talk", {6, 90, 2}, 94, 250ms, {}};
}

TEST(Stats, EmptyRunIsAnObjectToo) {
  const auto json = nlohmann::json::parse(Stats().to_json());
  EXPECT_EQ(json.at("program"), "au-transmitter");
  EXPECT_EQ(json.at("clients_total"), 0);
  EXPECT_EQ(json.at("packets"), 0);
  EXPECT_TRUE(json.at("clients").empty());
}

TEST(Stats, CountsEveryClientAndAll) {
  Stats stats;
  stats.add(record(1));
  ClientRecord second = record(2);
  second.level = 2;
  second.sent.keyframes = 3;
  second.sent.payload_bytes = 40;
  second.bytes_total = 100;
  second.send_time = 1500ms;
  second.end_reason = protocol::CloseConnection::Why::Stopped;
  second.sent.keyframes_merged = 5;
  second.sent.voice_left_out = 3;
  stats.add(second);

  const auto json = nlohmann::json::parse(stats.to_json());
  EXPECT_EQ(json.at("clients_total"), 2);
  EXPECT_EQ(json.at("packets"), 9);
  EXPECT_EQ(json.at("packets_merged"), 7);
  EXPECT_EQ(json.at("voice_left_out"), 3);
  EXPECT_EQ(json.at("bytes"), 130);
  EXPECT_EQ(json.at("bytes_total"), 194);
  EXPECT_DOUBLE_EQ(json.at("send_seconds").get<double>(), 1.75);
  EXPECT_EQ(json.at("clients_omitted"), 0);
  const auto& client = json.at("clients").at(1);
  EXPECT_EQ(client.at("client"), 2);
  EXPECT_EQ(client.at("peer"), "127.0.0.1:5000");
  EXPECT_EQ(client.at("level"), 2);
  EXPECT_EQ(client.at("stream"), "talk");
  EXPECT_EQ(client.at("packets"), 3);
  EXPECT_EQ(client.at("packets_merged"), 5);
  EXPECT_EQ(client.at("voice_left_out"), 3);
  EXPECT_EQ(client.at("bytes"), 40);
  EXPECT_EQ(client.at("bytes_total"), 100);
  EXPECT_DOUBLE_EQ(client.at("send_seconds").get<double>(), 1.5);
  EXPECT_EQ(client.at("end_reason"), "stopped");
}

TEST(Stats, KeepsTheLatestRecordsAndAllTotals) {
  Stats stats;
  const std::uint64_t clients = Stats::kRecordsMax + 5;
  for (std::uint64_t number = 1; number <= clients; ++number) stats.add(record(number));
  const auto json = nlohmann::json::parse(stats.to_json());
  ASSERT_EQ(json.at("clients").size(), Stats::kRecordsMax);
  EXPECT_EQ(json.at("clients").front().at("client"), 6);
  EXPECT_EQ(json.at("clients").back().at("client"), clients);
  EXPECT_EQ(json.at("packets"), 6 * clients);
  EXPECT_EQ(json.at("clients_total"), clients);
  EXPECT_EQ(json.at("clients_omitted"), 5);
}

TEST(Stats, AnyBytesMakeValidJson) {
  Stats stats;
  ClientRecord odd = record(1);
  odd.stream = "\xff\"\n";
  stats.add(odd);
  EXPECT_TRUE(nlohmann::json::accept(stats.to_json()));
}

}  // namespace
}  // namespace aucast::server
