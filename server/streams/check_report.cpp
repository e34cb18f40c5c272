#include "server/streams/check_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "common/action_unit.h"
#include "common/check.h"
#include "common/sources/found_report.h"
#include "common/text.h"
#include "protocol/caption.h"

namespace aucast::server {
namespace {

/// printf into a string, for short lines.
template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 256> line{};
  const int length = std::snprintf(line.data(), line.size(), format, values...);
  AUCAST_CHECK(length >= 0);
  return {line.data(), std::min(static_cast<std::size_t>(length), line.size() - 1)};
}

std::string bytes_line(const char* level, const protocol::PacketList& packets) {
  std::size_t smallest = packets[0].size();
  std::size_t largest = smallest;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    smallest = std::min(smallest, packets[i].size());
    largest = std::max(largest, packets[i].size());
  }
  return formatted("  %-11s %zu bytes, %.1f a keyframe (%zu to %zu)\n", level, packets.bytes(),
                   static_cast<double>(packets.bytes()) / static_cast<double>(packets.size()),
                   smallest, largest);
}

/// For a recording whose face is turned away most of the time: where it looks, and the remedy.
std::string turned_away_line(const StreamSummary& summary) {
  constexpr int kMuch = 25;
  std::string text;
  for (std::size_t turn = 0; turn < StreamSummary::kTurns.size(); ++turn) {
    const int percent = summary.median_turn(turn);
    if (std::abs(percent) < kMuch) continue;
    const int number = static_cast<int>(StreamSummary::kTurns[turn]) + (percent > 0 ? 0 : 1);
    text += (text.empty() ? "" : ", ") + std::string(facs_name(number).value_or("")) + " " +
            std::to_string(std::abs(percent)) + " %";
  }
  if (text.empty()) return {};
  return "  looks away  " + text +
         " most of the time; --neutral 2 straightens it if its first 2 s are like the rest\n";
}

/// The bit rate for a peer that takes the changes-only form and, if it is high, how to lower it.
std::string rate_line(const protocol::EncodedStream& served) {
  constexpr double kPromisedKbits = 12;
  const auto& packets = served.changes.empty() ? served.negotiated : served.changes;
  const auto ms = static_cast<double>(served.duration_ms.value_or(0));
  if (ms == 0) return {};
  const double kbits = static_cast<double>(packets.bytes()) * 8 / ms;
  return formatted(
      "  %-11s %.1f kbit/s%s\n", "bit rate", kbits,
      kbits <= kPromisedKbits ? "" : "; --max-bitrate 12, --rate 15 or --dead-band 5 lower it");
}

std::string au_lines(const StreamSummary& summary) {
  std::string text = "  AU  keyframes  percent  name\n";
  for (int number = 0; number < kAuCount; ++number) {
    const StreamSummary::Use& use = summary.uses[static_cast<std::size_t>(number)];
    if (use.keyframes == 0) continue;
    const std::string range =
        use.percent_low == use.percent_high
            ? std::to_string(use.percent_high)
            : std::to_string(use.percent_low) + "-" + std::to_string(use.percent_high);
    const std::string name(facs_name(number).value_or("(not a FACS number)"));
    text += formatted("  %2d  %9zu  %7s  %s\n", number, use.keyframes, range.c_str(), name.c_str());
  }
  return text;
}

std::string silence_lines(const std::vector<Silence>& silences) {
  constexpr std::size_t kShownMax = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(silences.size(), kShownMax); ++i) {
    text += formatted("  %-11s %.3f s to %.3f s\n", "silence", seconds(silences[i].begin),
                      seconds(silences[i].end));
  }
  if (silences.size() > kShownMax) {
    text += formatted("  %-11s and %zu times more for 3 s and longer\n", "",
                      silences.size() - kShownMax);
  }
  return text;
}

std::string voice_lines(const VoiceFile& file, const VoiceSummary& voice, Milliseconds face) {
  constexpr Milliseconds kMuch{1000};
  const std::vector<std::size_t> sizes = wire_sizes(voice.packets);
  const std::size_t bytes = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const double ms = std::max(static_cast<double>(voice.end.count()), 1.0);
  std::string text = formatted("  %-11s ", "voice") + printable(file.path.string()) +
                     formatted(": %.3f s, %.1f kbit/s in %zu packets\n", seconds(voice.end),
                               static_cast<double>(bytes) * 8 / ms, sizes.size());
  const Milliseconds promised = file.begin + file.duration;
  if (promised - voice.end > kMuch) {
    text += formatted("  %-11s it can be read up to %.3f s only, and should last %.3f s\n", "",
                      seconds(voice.end), seconds(promised));
  }
  if (!voice.complaint.empty()) text += formatted("  %-11s ", "") + voice.complaint + "\n";
  const Milliseconds longer = voice.end - face;
  if (longer > kMuch || -longer > kMuch) {
    text += formatted("  %-11s the voice ends at %.3f s, the face at %.3f s\n", "lengths",
                      seconds(voice.end), seconds(face));
  }
  return text + silence_lines(voice.silences);
}

std::string caption_lines(const std::vector<protocol::CaptionData>& captions) {
  if (captions.empty()) return {};
  const auto shown = std::count_if(captions.begin(), captions.end(),
                                   [](const auto& caption) { return !caption.text.empty(); });
  return formatted("  %-11s %td, from %.3f s to %.3f s\n", "captions", shown,
                   seconds(Milliseconds(captions.front().place_ms)),
                   seconds(Milliseconds(captions.back().place_ms)));
}

}  // namespace

std::string check_report(const Source& source, std::uint32_t keyframe_ms,
                         const VoiceSummary* voice) {
  const StreamSummary& summary = source.summary;
  const protocol::EncodedStream& served = *source.stream;
  std::string text = source.name + ": " + printable(source.path.string()) + "\n";
  if (!source.title.text.empty()) {
    text += formatted("  %-11s ", "title") + printable(source.title.text) +
            (protocol::is_title(source.title.text) ? "\n" : " (left out)\n");
  }
  if (source.found) text += sources::found_lines(*source.found);
  text += formatted("  %-11s %zu, %zu of them untimed\n", "keyframes", summary.keyframes,
                    summary.untimed);
  text += formatted("  %-11s %.3f s at %u ms an untimed keyframe\n", "duration",
                    seconds(Milliseconds(summary.duration_ms)), keyframe_ms);
  text += bytes_line("classic", served.classic);
  text += bytes_line("level 2", served.negotiated);
  if (!served.changes.empty()) text += bytes_line("changes", served.changes);
  text += rate_line(served);
  if (source.found) text += turned_away_line(summary);
  if (source.voice && voice != nullptr) {
    text += voice_lines(*source.voice, *voice, Milliseconds(summary.duration_ms));
  }
  text += caption_lines(source.captions);
  return text + au_lines(summary);
}

}  // namespace aucast::server
