#include "server/status/http_routes.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

class HttpRoutesTest : public ::testing::Test {
 protected:
  web::HttpReply get(const std::string& path, bool stopping = false) {
    return routes_.answer(path, stopping, now_);
  }

  int times_counted_ = 0;
  HttpRoutes routes_{[this](Instant) {
    Status status;
    status.clients = static_cast<std::uint64_t>(++times_counted_);
    return status;
  }};
  Instant now_ = Instant{} + 1h;
};

TEST_F(HttpRoutesTest, HealthIsKnownWithoutCounting) {
  EXPECT_EQ(get("/healthz").body, "ok\n");
  EXPECT_EQ(get("/healthz").status, 200);
  EXPECT_EQ(get("/healthz", true).body, "stopping\n");
  EXPECT_EQ(get("/healthz", true).status, 503);
  EXPECT_EQ(times_counted_, 0);
}

TEST_F(HttpRoutesTest, TheStatusIsCountedFourTimesASecondAtMost) {
  Status first;
  first.clients = 1;
  EXPECT_EQ(get("/status.json").body, status_json(first));
  now_ += 249ms;
  EXPECT_EQ(get("/metrics").body, metrics_text(first));
  EXPECT_EQ(times_counted_, 1);
  now_ += 1ms;
  get("/metrics");
  EXPECT_EQ(times_counted_, 2);
}

TEST_F(HttpRoutesTest, SaysWhatThereIs) {
  EXPECT_EQ(get("/").body, "/healthz\n/metrics\n/status.json\n");
  EXPECT_EQ(get("/metrics").type, "text/plain; version=0.0.4");
  EXPECT_EQ(get("/status.json").type, "application/json");
  EXPECT_EQ(get("/status").status, 404);
}

}  // namespace
}  // namespace aucast::server
