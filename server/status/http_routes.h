#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "common/time.h"
#include "common/web/http.h"
#include "server/status/status.h"

namespace aucast::server {

/// The replies of --http by path. Thread: none of its own.
class HttpRoutes {
 public:
  using StatusNow = std::function<Status(Instant now)>;

  explicit HttpRoutes(StatusNow status_now) : status_now_(std::move(status_now)) {}

  /// `stopping`: whether clients are no longer accepted.
  [[nodiscard]] web::HttpReply answer(const std::string& path, bool stopping, Instant now);

 private:
  [[nodiscard]] const Status& recent_status(Instant now);

  StatusNow status_now_;
  std::optional<Status> status_;
  Instant status_at_{};
};

}  // namespace aucast::server
