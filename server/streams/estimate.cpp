#include "server/streams/estimate.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <numeric>
#include <vector>

#include "common/text.h"
#include "server/streams/thinning.h"

namespace aucast::server {
namespace {

/// Bytes that are sent at one time.
struct Sent {
  Milliseconds at{0};
  std::size_t bytes = 0;
};

using Times = std::vector<protocol::KeyframeTime>;

/// What is sent for each keyframe.
std::vector<std::size_t> sizes_of(const protocol::PacketList& packets) {
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < packets.size(); ++i) sizes.push_back(packets[i].size());
  return sizes;
}

/// The same for the voice: its packets are sent with the keyframe during which they are heard.
std::vector<std::size_t> sizes_of(const VoiceSummary& voice, const Times& times) {
  std::vector<std::size_t> sizes(times.size());
  const std::vector<std::size_t> packets = wire_sizes(voice.packets);
  std::size_t keyframe = 0;
  Milliseconds end = times.front();
  for (std::size_t i = 0; i < packets.size(); ++i) {
    while (keyframe + 1 < times.size() && voice.packets[i].place >= end) end += times[++keyframe];
    sizes[keyframe] += packets[i];
  }
  return sizes;
}

/// Each is sent when the face begins to move to its keyframe, or together with others within
/// `batch`.
std::vector<Sent> sendings(const std::vector<std::size_t>& sizes, const Times& times,
                           Milliseconds batch, std::size_t headers) {
  std::vector<Sent> all;
  Milliseconds at{0};
  Milliseconds first{0};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (!all.empty() && at - first < batch) {
      all.back().bytes += sizes[i];
    } else {
      all.push_back({at + batch, sizes[i] + headers});
      first = at;
    }
    at += times[i];
  }
  return all;
}

std::size_t bytes_of(const std::vector<Sent>& all) {
  return std::accumulate(all.begin(), all.end(), std::size_t{0},
                         [](std::size_t sum, const Sent& one) { return sum + one.bytes; });
}

/// The bytes of the busiest second.
std::size_t peak_bytes(const std::vector<Sent>& all) {
  std::size_t most = 0;
  std::size_t inside = 0;
  auto oldest = all.begin();
  for (const Sent& newest : all) {
    inside += newest.bytes;
    while (newest.at - oldest->at >= Milliseconds(1000)) inside -= (oldest++)->bytes;
    most = std::max(most, inside);
  }
  return most;
}

double kbits(std::size_t bytes, double in_seconds) {
  return static_cast<double>(bytes) * 8 / 1000 / in_seconds;
}

std::string line_of(const char* form, const std::vector<std::size_t>& sizes,
                    const protocol::EncodedStream& stream, Milliseconds batch) {
  const std::vector<Sent> plain = sendings(sizes, stream.times, batch, 0);
  const std::vector<Sent> headed = sendings(sizes, stream.times, batch, kHeaderBytes);
  // A stream of no length goes out at once: then the peak says it all.
  const double length = std::max(seconds(protocol::length_of(stream)), 1.0);
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "  %-13s %10zu %9.1f %9.1f %12zu %9.1f %9.1f\n", form,
                bytes_of(plain), kbits(bytes_of(plain), length), kbits(peak_bytes(plain), 1),
                bytes_of(headed), kbits(bytes_of(headed), length), kbits(peak_bytes(headed), 1));
  return line.data();
}

std::vector<std::size_t> sum_of(std::vector<std::size_t> a, const std::vector<std::size_t>& b) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::plus<>());
  return a;
}

}  // namespace

std::string estimate_report(const Source& source, Milliseconds batch, const VoiceSummary* voice) {
  const protocol::EncodedStream& served = *source.stream;
  std::array<char, 200> head{};
  std::snprintf(head.data(), head.size(),
                "  %zu keyframes in %.3f s            kbit/s       with TCP/IP          kbit/s\n"
                "  form               bytes      mean      peak        bytes      mean      peak\n",
                served.negotiated.size(), seconds(protocol::length_of(served)));
  std::string text = at_place(source.path.string(), source.name) + "\n" + head.data();
  const auto add = [&](const char* form, const protocol::EncodedStream& stream,
                       const std::vector<std::size_t>& sizes) {
    text += line_of(form, sizes, stream, batch);
  };
  add("classic", served, sizes_of(served.classic));
  add("level 2", served, sizes_of(served.negotiated));
  if (!served.changes.empty()) add("changes", served, sizes_of(served.changes));
  if (voice == nullptr) return text;
  const protocol::EncodedStream& voiced = source.voiced ? *source.voiced : served;
  const std::vector<std::size_t> sound = sizes_of(*voice, voiced.times);
  add("voice alone", voiced, sound);
  add("level 2+voice", voiced, sum_of(sizes_of(voiced.negotiated), sound));
  if (!voiced.changes.empty())
    add("changes+voice", voiced, sum_of(sizes_of(voiced.changes), sound));
  return text;
}

}  // namespace aucast::server
