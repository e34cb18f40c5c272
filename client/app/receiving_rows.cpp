#include "client/app/receiving_rows.h"

#include "client/app/read_number.h"
#include "client/playback/keyframe_buffers.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;

constexpr double kSecondsMax = 86'400;
constexpr int kDelayMaxMs = playback::BufferOptions::kDelayMax.count();

Complaint read_buffer(const std::string& word, playback::BufferOptions& buffers) {
  constexpr std::size_t kSetsMax = playback::BufferOptions::kSetsMax;
  if (read_whole(word, std::size_t{1}, kSetsMax, buffers.receiver_capacity)) {
    return std::nullopt;
  }
  int time_ms = 0;
  const bool timed =
      word.ends_with("ms") &&
      read_whole(std::string_view(word).substr(0, word.size() - 2), 0, kDelayMaxMs, time_ms);
  if (word != "auto" && !timed) {
    return "is neither auto, nor a time of 0ms to " + std::to_string(kDelayMaxMs) + "ms, nor " +
           text_of_range(1, kSetsMax) + " sets";
  }
  buffers.receiver_capacity = playback::kReceiverSetsByTime;
  buffers.by_time = true;
  if (timed) {
    buffers.live_delay = Milliseconds(time_ms);
    buffers.adapt = false;
  }
  return std::nullopt;
}

Complaint read_live_delay(const std::string& word, playback::BufferOptions& buffers) {
  buffers.adapt = false;
  return whole(buffers.live_delay, 0, kDelayMaxMs).read(word);
}

std::vector<OptionRow> security_rows(net::SecurityOptions& security) {
  return {
      {.option = {"tls"},
       .text = "use TLS",
       .more = "Encrypt the connection and verify the server's certificate.",
       .value = flag(security.tls),
       .heading = "TLS and tokens"},
      {.option = {"tls-ca", "FILE"},
       .text = "CAs to trust",
       .more = "Trust the authorities in FILE (PEM) and not the system's. If FILE has revocation "
               "lists, they are heeded; each authority that signs for servers then needs one that "
               "is up to date.",
       .value = word(security.files.authorities)},
      {.option = {"tls-cert", "FILE"},
       .text = "certificate to show, if the server wants one",
       .more = "The certificate to present if the server requires one (PEM).",
       .value = word(security.files.certificate)},
      {.option = {"tls-key", "FILE"},
       .text = "the private key of --tls-cert",
       .value = word(security.files.key)},
      {.option = {"token-file", "FILE"},
       .text = "token to show to the server",
       .more = "The file with the token that the server requires. The token is sent only over TLS "
               "or to this computer, unless --insecure-token is given.",
       .value = word(security.token)},
      {.option = {"insecure-token"},
       .text = "send the token even without TLS",
       .more = "Send the token without TLS to other computers too: anyone on the path can read it.",
       .value = flag(security.insecure_token)},
  };
}

}  // namespace

std::vector<OptionRow> table_rows(gui::TableSettings& table) {
  return {
      {.option = {"table-fps", "N"},
       .text = "pictures per second in a table without times",
       .more = "How many pictures a second a recogniser's table was made from, 1 to 1000. Without "
               "this option the table's own times count.",
       .value = whole(table.fps, 1, gui::kTableFpsMax),
       .heading = "Tables of recognisers"},
      {.option = {"table-gain", "PERCENT"},
       .text = "gain for all AUs of a table",
       .more = "Multiplies the intensities of all AUs of a table, 1 to 1000 percent.",
       .value = whole(table.gain_percent, 1, gui::kTableGainPercentMax)},
      {.option = {"table-neutral", "S"},
       .text = "the first S seconds show a neutral face: subtract it",
       .more = "The first S seconds of a table, 1 to 60, show a neutral face, which is subtracted "
               "from the whole table.",
       .value = whole(table.neutral_s, 1, gui::kTableNeutralMax)},
  };
}

std::vector<OptionRow> receiving_rows(PlaybackOptions& playback) {
  playback::BufferOptions& buffers = playback.buffers;
  std::vector<OptionRow> rows{
      {.option = {"buffer", "SIZE", "100"},
       .text = "Receiver buffer: N sets (100), 300ms or auto",
       .more = "Capacity of the Receiver buffer, 1 to 10000 sets. With auto the buffer is counted "
               "in time instead, as much as the link needs; with a time such as 300ms, up to "
               "60000ms, it holds that much.",
       .value = parsed(Kind::Word, read_buffer, buffers),
       .heading = "Receiving"},
      {.option = {"playout", "N", "30"},
       .text = "Playout buffer: N sets about to be played (30)",
       .more = "Capacity of the Playout buffer, in sets; no larger than --buffer.",
       .value = whole(buffers.playout_capacity, 1, playback::BufferOptions::kSetsMax)},
      {.option = {"threshold", "PERCENT", "40"},
       .text = "start when the Receiver buffer is this full (40)",
       .more = "How full the Receiver buffer must be before playback starts, 1 to 100 percent.",
       .value = whole(buffers.threshold_percent, 1, 100)},
      {.option = {"live"},
       .text = "lowest delay for live streams; may stall",
       .more = "The lowest delay of a live stream that the link allows, at the risk of stalls.",
       .value = flag(buffers.low_delay)},
      {.option = {"live-delay", "MS"},
       .text = "fixed delay for live streams (default: adaptive)",
       .more = "A fixed delay for live streams, up to 60000 ms. Without it the delay adapts to the "
               "link.",
       .value = parsed(Kind::Number, read_live_delay, buffers)},
      {.option = {"hold", "S", "5"},
       .text = "return to neutral after a stall of S seconds (5)",
       .value =
           seconds(playback.hold, 0, kSecondsMax, "is not a number of seconds from 0 to 86400")},
      {.option = {"stream", "NAME"},
       .text = "which of the server's streams (its first)",
       .more = "Which of the server's streams; its first one by default.",
       .value = word(playback.stream)},
      {.option = {"protocol", "LEVEL", "auto"},
       .text = "auto or classic (auto)",
       .more = "classic never sends a hello: for servers that know only level 1.",
       .value = one_of(playback.classic, {{"auto", false}, {"classic", true}})},
      {.option = {"connect-timeout", "S", "10"},
       .text = "longest wait to connect and for the first packet (10)",
       .more = "The longest wait for a connection and for its first packet, 0.01 to 86400 seconds.",
       .value = seconds(playback.connect_timeout, 0.01, kSecondsMax,
                        "is not a number of seconds from 0.01 to 86400")},
      {.option = {"reconnect"},
       .text = "when the connection is lost, hold the face and retry",
       .more = "When the connection is lost, hold the face and retry after 1, 2, 4, 8, 16, 30, 30 "
               "... seconds.",
       .value = flag(playback.reconnect)}};
  append(rows, security_rows(playback.security));
  return rows;
}

}  // namespace aucast::app
