#include "server/status/http_routes.h"

namespace aucast::server {
namespace {

constexpr const char* kPlainText = "text/plain; charset=utf-8";

/// How old an answer about the status may be.
constexpr Milliseconds kStatusAge{250};

}  // namespace

web::HttpReply HttpRoutes::answer(const std::string& path, bool stopping, Instant now) {
  if (path == "/healthz")
    return {stopping ? 503 : 200, kPlainText, stopping ? "stopping\n" : "ok\n"};
  if (path == "/metrics")
    return {200, "text/plain; version=0.0.4", metrics_text(recent_status(now))};
  if (path == "/status.json") return {200, "application/json", status_json(recent_status(now))};
  if (path == "/") return {200, kPlainText, "/healthz\n/metrics\n/status.json\n"};
  return {404, kPlainText, "there are /healthz, /metrics and /status.json\n"};
}

/// A status that is at most a little old, so that clients are not counted for every request.
const Status& HttpRoutes::recent_status(Instant now) {
  if (!status_ || now - status_at_ >= kStatusAge) {
    status_ = status_now_(now);
    status_at_ = now;
  }
  return *status_;
}

}  // namespace aucast::server
