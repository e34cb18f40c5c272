#include "server/status/stats.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace aucast::server {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const ClientRecord& record) {
  return {{"client", record.number},
          {"peer", record.peer},
          {"level", record.level},
          {"stream", record.stream},
          {"packets", record.keyframes},
          {"packets_merged", record.keyframes_merged},
          {"bytes", record.bytes},
          {"bytes_total", record.bytes_total},
          {"voice_packets", record.voice_packets},
          {"voice_left_out", record.voice_left_out},
          {"sound_bytes", record.spoken_bytes},
          {"send_seconds", seconds(record.send_time)},
          {"end_reason", name(record.end_reason)}};
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
  keyframes += record.keyframes;
  keyframes_merged += record.keyframes_merged;
  bytes += record.bytes;
  bytes_total += record.bytes_total;
  voice_packets += record.voice_packets;
  spoken_bytes += record.spoken_bytes;
  voice_left_out += record.voice_left_out;
  send_time += record.send_time;
}

void Stats::add(ClientRecord record) {
  add_pushed(record);
  ++clients_;
  ++end_reasons_[std::string(name(record.end_reason))];
  records_.push_back(std::move(record));
  if (records_.size() > kRecordsMax) records_.pop_front();
}

std::string Stats::to_json() const {
  Json clients = Json::array();
  for (const ClientRecord& record : records_) clients.push_back(json_of(record));
  const Json all = {{"program", "au-transmitter"},
                    {"clients_total", clients_},
                    {"packets", totals_.keyframes},
                    {"packets_merged", totals_.keyframes_merged},
                    {"bytes", totals_.bytes},
                    {"bytes_total", totals_.bytes_total},
                    {"voice_packets", totals_.voice_packets},
                    {"voice_left_out", totals_.voice_left_out},
                    {"sound_bytes", totals_.spoken_bytes},
                    {"send_seconds", seconds(totals_.send_time)},
                    {"clients_omitted", clients_ - records_.size()},
                    {"clients", std::move(clients)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aucast::server
