#include "server/streams/estimate.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <vector>

#include "common/text.h"
#include "server/streams/thinning.h"

namespace aucast::server {
namespace {

/// Bytes that go out at a moment of the stream.
struct Sent {
  Milliseconds at{0};
  std::size_t bytes = 0;
};

/// Each packet goes out when the face is to set out for it, or with others within `batch`.
std::vector<Sent> sendings(const protocol::PacketList& packets,
                           const std::vector<protocol::KeyframeTime>& times, Milliseconds batch,
                           std::size_t headers) {
  std::vector<Sent> all;
  Milliseconds at{0};
  Milliseconds first{0};
  for (std::size_t i = 0; i < packets.size(); ++i) {
    if (!all.empty() && at - first < batch) {
      all.back().bytes += packets[i].size();
    } else {
      all.push_back({at + batch, packets[i].size() + headers});
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

/// Of the second that has most.
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

double kbits(std::size_t bytes, double seconds) {
  return static_cast<double>(bytes) * 8 / 1000 / seconds;
}

std::string line_of(const char* form, const protocol::PacketList& packets,
                    const protocol::EncodedStream& served, Milliseconds batch) {
  const std::vector<Sent> plain = sendings(packets, served.times, batch, 0);
  const std::vector<Sent> headed = sendings(packets, served.times, batch, kHeaderBytes);
  const Milliseconds whole =
      std::accumulate(served.times.begin(), served.times.end(), Milliseconds::zero());
  // A stream of no length goes out at once: then the peak says it all.
  const double seconds = std::max(static_cast<double>(whole.count()) / 1000, 1.0);
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "  %-13s %10zu %9.1f %9.1f %12zu %9.1f %9.1f\n", form,
                bytes_of(plain), kbits(bytes_of(plain), seconds), kbits(peak_bytes(plain), 1),
                bytes_of(headed), kbits(bytes_of(headed), seconds), kbits(peak_bytes(headed), 1));
  return line.data();
}

}  // namespace

std::string estimate_report(const Source& source, Milliseconds batch) {
  const protocol::EncodedStream& served = *source.stream;
  const Milliseconds whole =
      std::accumulate(served.times.begin(), served.times.end(), Milliseconds::zero());
  std::array<char, 200> head{};
  std::snprintf(head.data(), head.size(),
                "  %zu keyframes in %.3f s            kbit/s       with TCP/IP          kbit/s\n"
                "  form               bytes      mean      peak        bytes      mean      peak\n",
                served.negotiated.size(), static_cast<double>(whole.count()) / 1000);
  std::string text = at_place(source.path.string(), source.name) + "\n" + head.data();
  text += line_of("classic", served.classic, served, batch);
  text += line_of("level 2", served.negotiated, served, batch);
  if (!served.changes.empty()) text += line_of("changes only", served.changes, served, batch);
  return text;
}

}  // namespace aucast::server
