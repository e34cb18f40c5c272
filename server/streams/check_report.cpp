#include "server/streams/check_report.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/check.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// printf into a string; all our lines are short.
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
  return formatted("  %-11s %zu bytes, %.1f a packet (%zu to %zu)\n", level, packets.bytes(),
                   static_cast<double>(packets.bytes()) / static_cast<double>(packets.size()),
                   smallest, largest);
}

/// How one AU is used: the larger side of it counts.
struct Use {
  std::size_t packets = 0;
  int percent_low = 100;
  int percent_high = 0;
};

std::array<Use, kAuCount> uses_of(const protocol::StreamFile& stream) {
  std::array<Use, kAuCount> uses{};
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    std::array<int, kAuCount> percents{};
    // The canonical form of a neutral face is AU 0, so neutral packets are counted there.
    for (const AuTerm& term : canonical_terms(frame_from_terms(keyframe.terms))) {
      percents[term.number] = std::max(percents[term.number], int{term.percent});
    }
    for (std::size_t number = 0; number < uses.size(); ++number) {
      if (percents[number] == 0) continue;
      Use& use = uses[number];
      ++use.packets;
      use.percent_low = std::min(use.percent_low, percents[number]);
      use.percent_high = std::max(use.percent_high, percents[number]);
    }
  }
  return uses;
}

/// Of a recording whose face is turned away most of the time (in the middle of all keyframes):
/// where it looks, and what mends it.
std::string turned_away_line(const protocol::StreamFile& stream) {
  constexpr int kMuch = 25;
  constexpr std::array<std::size_t, 5> kTurns{51, 53, 55, 61, 63};
  std::array<std::vector<float>, kTurns.size()> turns;
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    const AuFrame frame = frame_from_terms(keyframe.terms);
    for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
      turns[turn].push_back(frame.left[kTurns[turn]] - frame.left[kTurns[turn] + 1]);
    }
  }
  std::string text;
  for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
    const auto size = static_cast<std::ptrdiff_t>(turns[turn].size());
    const auto middle = turns[turn].begin() + size / 2;
    std::nth_element(turns[turn].begin(), middle, turns[turn].end());
    const auto percent = static_cast<int>(std::lround(*middle * 100));
    if (std::abs(percent) < kMuch) continue;
    const int number = static_cast<int>(kTurns[turn]) + (percent > 0 ? 0 : 1);
    text += (text.empty() ? "" : ", ") + std::string(facs_name(number).value_or("")) + " " +
            std::to_string(std::abs(percent)) + " %";
  }
  if (text.empty()) return {};
  return "  looks away  " + text +
         " most of the time; --neutral 2 straightens it if its first 2 s are like the rest\n";
}

/// The bit rate of what is sent to a peer that takes changes, and what lowers it where it is much.
std::string rate_line(const protocol::EncodedStream& served) {
  constexpr double kPromisedKbits = 12;
  const auto& packets = served.changes.empty() ? served.negotiated : served.changes;
  std::chrono::milliseconds time{};
  for (const auto one : served.times) time += one;
  if (time.count() == 0) return {};
  const double kbits = static_cast<double>(packets.bytes()) * 8 / static_cast<double>(time.count());
  return formatted(
      "  %-11s %.1f kbit/s%s\n", "bit rate", kbits,
      kbits <= kPromisedKbits ? "" : "; --max-bitrate 12, --rate 15 or --dead-band 5 lower it");
}

std::string au_lines(const protocol::StreamFile& stream) {
  const auto uses = uses_of(stream);
  std::string text = "  AU  packets  percent  name\n";
  for (int number = 0; number < kAuCount; ++number) {
    const Use& use = uses[static_cast<std::size_t>(number)];
    if (use.packets == 0) continue;
    const std::string range =
        use.percent_low == use.percent_high
            ? std::to_string(use.percent_high)
            : std::to_string(use.percent_low) + "-" + std::to_string(use.percent_high);
    const std::string name(facs_name(number).value_or("(not a FACS number)"));
    text += formatted("  %2d  %7zu  %7s  %s\n", number, use.packets, range.c_str(), name.c_str());
  }
  return text;
}

}  // namespace

std::string check_report(const Source& source, const protocol::EncodedStream& served,
                         std::uint32_t keyframe_ms) {
  const auto& keyframes = source.stream.keyframes;
  const auto untimed = std::count_if(
      keyframes.begin(), keyframes.end(),
      [](const protocol::Keyframe& keyframe) { return !keyframe.duration_ms.has_value(); });
  std::string text = source.name + ": " + printable(source.path.string()) + "\n";
  if (source.found) text += sources::found_lines(*source.found);
  text += formatted("  %-11s %zu, %td of them untimed\n", "packets", keyframes.size(), untimed);
  text += formatted("  %-11s %.3f s at %u ms an untimed keyframe\n", "duration",
                    static_cast<double>(protocol::media_ms(source.stream, keyframe_ms)) / 1000.0,
                    keyframe_ms);
  text += bytes_line("classic", served.classic);
  text += bytes_line("negotiated", served.negotiated);
  if (!served.changes.empty()) text += bytes_line("changes", served.changes);
  text += rate_line(served);
  if (source.found) text += turned_away_line(source.stream);
  return text + au_lines(source.stream);
}

}  // namespace aucast::server
