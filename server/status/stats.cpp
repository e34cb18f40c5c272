#include "server/status/stats.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace aucast::server {
namespace {

using Json = nlohmann::ordered_json;

void add_sent(Json& json, const protocol::SentCounts& sent, std::uint64_t bytes_total,
              Duration send_time) {
  json["packets"] = sent.keyframes;
  json["packets_merged"] = sent.keyframes_merged;
  json["bytes"] = sent.payload_bytes;
  json["bytes_total"] = bytes_total;
  json["voice_packets"] = sent.voice_packets;
  json["voice_left_out"] = sent.voice_left_out;
  json["sound_bytes"] = sent.spoken_bytes;
  json["send_seconds"] = seconds(send_time);
}

Json json_of(const ClientRecord& record) {
  Json json = {{"client", record.number},
               {"peer", record.peer},
               {"level", record.level},
               {"stream", record.stream}};
  add_sent(json, record.sent, record.bytes_total, record.send_time);
  json["end_reason"] = name(record.end_reason);
  return json;
}

std::string_view name_of(EndedHere reason) {
  switch (reason) {
    case EndedHere::HandedOver:
      return "publishes";
    case EndedHere::TimedOut:
      return "timed out";
    case EndedHere::TlsFailed:
      return "tls failed";
  }
  return "unknown";
}

}  // namespace

std::string_view name(ClientEnd reason) {
  const auto* here = std::get_if<EndedHere>(&reason);
  return here != nullptr ? name_of(*here) : name(std::get<protocol::CloseConnection::Why>(reason));
}

void Totals::add(const ClientRecord& record) {
  sent += record.sent;
  bytes_total += record.bytes_total;
  send_time += record.send_time;
}

void Stats::add(ClientRecord record) {
  totals_.add(record);
  ++clients_;
  ++end_reasons_[std::string(name(record.end_reason))];
  records_.push_back(std::move(record));
  if (records_.size() > kRecordsMax) records_.pop_front();
}

std::string Stats::to_json() const {
  Json clients = Json::array();
  for (const ClientRecord& record : records_) clients.push_back(json_of(record));
  Json all = {{"program", "au-transmitter"}, {"clients_total", clients_}};
  add_sent(all, totals_.sent, totals_.bytes_total, totals_.send_time);
  all["clients_omitted"] = clients_ - records_.size();
  all["clients"] = std::move(clients);
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aucast::server
