#include "server/status/status.h"

#include <cmath>
#include <numeric>
#include <string_view>

#include <nlohmann/json.hpp>

#include "protocol/limits.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {
namespace {

using Json = nlohmann::ordered_json;

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(seconds);
  const auto part = [](std::uint64_t count, const char* unit) {
    return std::to_string(count) + " " + unit;
  };
  if (whole < 60) return part(whole, "s");
  if (whole < 3600) return part(whole / 60, "min");
  if (whole < 86400) return part(whole / 3600, "h") + " " + part(whole / 60 % 60, "min");
  return part(whole / 86400, "d") + " " + part(whole / 3600 % 24, "h");
}

std::uint64_t sum_of(const std::map<std::string, std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& entry) { return sum + entry.second; });
}

/// A JSON or Prometheus number.
std::string number(double value) {
  return Json(std::isfinite(value) ? value : 0.0).dump();
}

/// Writes one family of metrics: its two comment lines, then its samples.
class Family {
 public:
  Family(std::string& text, std::string_view name, std::string_view type, std::string_view help)
      : text_(text), name_(name) {
    text_ += "# HELP " + name_ + " " + std::string(help) + "\n";
    text_ += "# TYPE " + name_ + " " + std::string(type) + "\n";
  }

  /// `labels`: empty, or key="value" pairs. Our values need no escaping: they are our
  /// words, names of streams and addresses, which have neither quotes nor backslashes.
  void sample(const std::string& value, const std::string& labels = {}) {
    text_ += name_ + (labels.empty() ? "" : "{" + labels + "}") + " " + value + "\n";
  }

 private:
  std::string& text_;
  std::string name_;
};

enum class Type : std::uint8_t { Gauge, Counter };

/// A number of the status, as a metric and as a member of the JSON object.
struct Number {
  const char* key;
  const char* metric;
  Type type;
  const char* help;
  Json value;
};

std::vector<Number> numbers_of(const Status& status) {
  const protocol::SentCounts& sent = status.totals.sent;
  return {
      {"up_seconds", "aucast_uptime_seconds", Type::Gauge, "Since the transmitter was ready.",
       status.up_seconds},
      {"clients", "aucast_clients", Type::Gauge, "Connected now.", status.clients},
      {"clients_web", "aucast_clients_web", Type::Gauge, "Of those, by WebSocket.",
       status.clients_web},
      {"clients_paused", "aucast_clients_paused", Type::Gauge, "Of those, paused.",
       status.clients_paused},
      {"clients_behind", "aucast_clients_behind", Type::Gauge,
       "Of those, something waits for them to take it.", status.clients_behind},
      {"connects", "aucast_connects_total", Type::Counter, "Connections that were heard.",
       status.connects},
      {"connects_unheard", "aucast_connects_unheard_total", Type::Counter,
       "Closed at once, for want of room.", status.connects_unheard},
      {"accept_failures", "aucast_accept_failures_total", Type::Counter,
       "Times that accepting had to pause.", status.accept_failures},
      {"wrong_tokens", "aucast_wrong_tokens_total", Type::Counter,
       "Tokens of viewers and publishers that were compared and found wrong.", status.wrong_tokens},
      {"packets", "aucast_packets_total", Type::Counter, "Keyframes handed out.", sent.keyframes},
      {"packets_merged", "aucast_packets_merged_total", Type::Counter,
       "Live keyframes dropped for a newer one because a client was slow.", sent.keyframes_merged},
      {"bytes", "aucast_packet_bytes_total", Type::Counter, "Bytes of keyframes.",
       sent.payload_bytes},
      {"bytes_total", "aucast_bytes_total", Type::Counter, "All bytes that the sockets took.",
       status.totals.bytes_total},
      {"voice_packets", "aucast_voice_packets_total", Type::Counter, "Packets of voice handed out.",
       sent.voice_packets},
      {"voice_left_out", "aucast_voice_left_out_total", Type::Counter,
       "Packets of live voice dropped because a client was slow.", sent.voice_left_out},
      {"sound_bytes", "aucast_sound_bytes_total", Type::Counter,
       "Bytes of voice packets and captions.", sent.spoken_bytes},
      {"queue_bytes", "aucast_queue_bytes", Type::Gauge,
       "Bytes that wait for clients to take them.", status.queue_bytes},
      {"queue_seconds", "aucast_queue_seconds", Type::Gauge,
       "Longest time that anything waits for one client.", status.queue_seconds},
      {"lag_seconds", "aucast_lag_seconds", Type::Gauge,
       "How late the latest live keyframe was sent.", status.lag_seconds},
      {"reloads", "aucast_reloads_total", Type::Counter, "Reloads by SIGHUP that worked.",
       status.reloads},
      {"reload_failures", "aucast_reload_failures_total", Type::Counter,
       "Reloads by SIGHUP that took over nothing.", status.reload_failures},
  };
}

/// The families of the streams that come from other servers; none without such a stream.
void add_upstreams(std::string& text, const std::vector<UpstreamStatus>& upstreams) {
  if (upstreams.empty()) return;
  const auto add = [&](std::string_view name, std::string_view type, std::string_view help,
                       const auto& value_of) {
    Family family(text, name, type, help);
    for (const UpstreamStatus& upstream : upstreams) {
      family.sample(std::to_string(value_of(upstream)), "stream=\"" + upstream.stream + "\"");
    }
  };
  add("aucast_upstream_receiving", "gauge", "A parent sends the stream.",
      [](const UpstreamStatus& upstream) { return upstream.receiving ? 1 : 0; });
  add("aucast_upstream_connects_total", "counter", "Connections to parents.",
      [](const UpstreamStatus& upstream) { return upstream.connects; });
  add("aucast_upstream_losses_total", "counter", "Parents that were lost while they sent.",
      [](const UpstreamStatus& upstream) { return upstream.losses; });
  add("aucast_upstream_packets_total", "counter", "Keyframes received.",
      [](const UpstreamStatus& upstream) { return upstream.keyframes; });
  add("aucast_upstream_bytes_total", "counter", "Bytes of those.",
      [](const UpstreamStatus& upstream) { return upstream.bytes; });
  add("aucast_upstream_captions_left_out_total", "counter", "Captions too far ahead of the face.",
      [](const UpstreamStatus& upstream) { return upstream.captions_left_out; });
}

/// The same for the streams that are pushed to other servers.
void add_pushes(std::string& text, const std::vector<PushStatus>& pushes) {
  if (pushes.empty()) return;
  const auto add = [&](std::string_view name, std::string_view type, std::string_view help,
                       const auto& value_of) {
    // Two may reach one server by different lists of hosts, and no sample may come twice.
    std::map<std::string, std::uint64_t> samples;
    for (const PushStatus& push : pushes) {
      samples["stream=\"" + push.stream + "\",server=\"" + push.server + "\""] += value_of(push);
    }
    Family family(text, name, type, help);
    for (const auto& [labels, value] : samples) family.sample(std::to_string(value), labels);
  };
  add("aucast_push_sending", "gauge", "The other server takes the stream.",
      [](const PushStatus& push) { return push.sending ? 1U : 0U; });
  add("aucast_push_connects_total", "counter", "Times that it was taken.",
      [](const PushStatus& push) { return push.connects; });
  add("aucast_push_losses_total", "counter", "Times that it was lost there.",
      [](const PushStatus& push) { return push.losses; });
}

}  // namespace

std::vector<std::string> status_lines(const Status& status) {
  const auto text = [](std::uint64_t count) { return std::to_string(count); };
  const protocol::SentCounts& sent = status.totals.sent;
  std::string reasons;
  for (const auto& [reason, count] : status.disconnects) {
    reasons += (reasons.empty() ? " (" : ", ") + text(count) + " " + reason;
  }
  if (!reasons.empty()) reasons += ")";
  std::string names;
  for (const std::string& name : status.streams) names += " " + name;
  std::vector<std::string> lines = {
      "status: up " + duration_text(status.up_seconds) + "; clients " + text(status.clients) +
          ", paused " + text(status.clients_paused) + ", behind " + text(status.clients_behind) +
          ", web " + text(status.clients_web),
      "status: came " + text(status.connects) + ", left " + text(sum_of(status.disconnects)) +
          reasons + ", closed unheard " + text(status.connects_unheard) + ", accept failures " +
          text(status.accept_failures) + ", wrong tokens " + text(status.wrong_tokens),
      "status: sent " + text(sent.keyframes) + " packets, " + text(status.totals.bytes_total) +
          " bytes; merged " + text(sent.keyframes_merged) + "; waiting " +
          text(status.queue_bytes) + " bytes, the longest " + number(status.queue_seconds) +
          " s; lag " + number(status.lag_seconds) + " s",
      "status: " + std::string(status.live ? "live" : "recorded") + " streams:" + names,
  };
  if (sent.spoken_bytes > 0) {
    lines.push_back("status: of that, voice " + text(sent.voice_packets) + " packets" +
                    (sent.voice_left_out > 0 ? ", left out " + text(sent.voice_left_out) : "") +
                    "; sound and captions " + text(sent.spoken_bytes) + " bytes");
  }
  for (const UpstreamStatus& upstream : status.upstreams) {
    lines.push_back("status: upstream " + upstream.stream + " " +
                    (upstream.receiving ? "from " + upstream.parent : "from nobody") +
                    ": connections " + text(upstream.connects) + ", lost " + text(upstream.losses) +
                    ", received " + text(upstream.keyframes) + " packets, " + text(upstream.bytes) +
                    " bytes" +
                    (upstream.captions_left_out > 0
                         ? ", left out " + text(upstream.captions_left_out) + " captions"
                         : ""));
  }
  for (const PushStatus& push : status.pushes) {
    lines.push_back("status: push " + push.stream + " to " + push.server + ": " +
                    (push.sending ? "taken" : "not taken") + ", connections " +
                    text(push.connects) + ", lost " + text(push.losses));
  }
  if (status.engine) {
    lines.push_back("status: NATS: left out " + text(status.engine->messages_left_out) +
                    " messages, " + text(status.engine->batches_left_out) + " batches, " +
                    text(status.engine->questions_left_out) + " questions");
  }
  return lines;
}

std::string metrics_text(const Status& status) {
  std::string text;
  Family(text, "aucast_build_info", "gauge", "Version of the program and of its protocol.")
      .sample("1", "version=\"" + version_number() + "\",protocol=\"" +
                       std::to_string(protocol::kProtocolVersion) + "\"");
  Family(text, "aucast_streams", "gauge", "Streams that are served.")
      .sample(std::to_string(status.streams.size()));
  for (const Number& one : numbers_of(status)) {
    const bool gauge = one.type == Type::Gauge;
    Family(text, one.metric, gauge ? "gauge" : "counter", one.help)
        .sample(gauge ? number(one.value.get<double>()) : one.value.dump());
  }
  Family disconnects(text, "aucast_disconnects_total", "counter", "Connections that ended.");
  for (const auto& [reason, count] : status.disconnects) {
    disconnects.sample(std::to_string(count), "reason=\"" + reason + "\"");
  }
  add_upstreams(text, status.upstreams);
  add_pushes(text, status.pushes);
  if (status.engine) {
    Family family(text, "aucast_engine_left_out_total", "counter",
                  "What NATS brought and there was no room or time for.");
    family.sample(std::to_string(status.engine->messages_left_out), "what=\"messages\"");
    family.sample(std::to_string(status.engine->batches_left_out), "what=\"batches\"");
    family.sample(std::to_string(status.engine->questions_left_out), "what=\"questions\"");
  }
  return text;
}

std::string status_json(const Status& status) {
  Json disconnects = Json::object();
  for (const auto& [reason, count] : status.disconnects) disconnects[reason] = count;
  Json upstreams = Json::array();
  for (const UpstreamStatus& upstream : status.upstreams) {
    upstreams.push_back({{"stream", upstream.stream},
                         {"parent", upstream.parent},
                         {"receiving", upstream.receiving},
                         {"connects", upstream.connects},
                         {"losses", upstream.losses},
                         {"packets", upstream.keyframes},
                         {"bytes", upstream.bytes},
                         {"captions_left_out", upstream.captions_left_out}});
  }
  Json pushes = Json::array();
  for (const PushStatus& push : status.pushes) {
    pushes.push_back({{"stream", push.stream},
                      {"server", push.server},
                      {"sending", push.sending},
                      {"connects", push.connects},
                      {"losses", push.losses}});
  }
  Json all = {{"program", "au-transmitter"},
              {"version", version_number()},
              {"protocol", protocol::kProtocolVersion},
              {"live", status.live},
              {"stopping", status.stopping},
              {"streams", status.streams},
              {"disconnects", std::move(disconnects)}};
  for (Number& one : numbers_of(status)) all[one.key] = std::move(one.value);
  all["upstreams"] = std::move(upstreams);
  all["pushes"] = std::move(pushes);
  if (status.engine) {
    all["engine"] = {{"messages_left_out", status.engine->messages_left_out},
                     {"batches_left_out", status.engine->batches_left_out},
                     {"questions_left_out", status.engine->questions_left_out}};
  }
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aucast::server
