#include "server/streams/estimate.h"

#include <gtest/gtest.h>

#include "tests/unit/protocol/packets.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

/// Four packets of ten bytes.
Source talk(const std::vector<Milliseconds>& times) {
  protocol::EncodedStream stream;
  stream.classic = test::packets({"{12:34;56}", "{12:34;56}", "{12:34;56}", "{12:34;56}"});
  stream.negotiated = stream.classic;
  for (const Milliseconds time : times) stream.times.emplace_back(time.count());
  return {"talk.txt", "talk", std::make_shared<const protocol::EncodedStream>(std::move(stream))};
}

bool holds(const std::string& text, const std::string& line) {
  return text.find(line + "\n") != std::string::npos;
}

TEST(Estimate, CountsBytesMeanAndPeak) {
  // Two seconds; three of the packets are in the second that has most.
  const Source source = talk({500ms, 499ms, 1ms, 1s});
  const std::string report = estimate_report(source, 0ms);
  EXPECT_TRUE(holds(report, "talk.txt: talk"));
  EXPECT_NE(report.find("  4 keyframes in 2.000 s "), std::string::npos) << report;
  EXPECT_TRUE(holds(
      report, "  classic               40       0.2       0.2          248       1.0       1.5"))
      << report;
  EXPECT_EQ(report.find("changes"), std::string::npos);
}

TEST(Estimate, SharesHeadersWithinABatch) {
  const Source source = talk({100ms, 100ms, 100ms, 700ms});
  const std::string report = estimate_report(source, 200ms);
  EXPECT_TRUE(holds(
      report, "  level 2               40       0.3       0.3          144       1.2       1.2"))
      << report;
}

}  // namespace
}  // namespace aucast::server
