#pragma once

#include "common/result.h"
#include "server/upstream/reception.h"

namespace aucast::server {

/// A stream of another server as a source: one Reception, and whatever makes the connections for
/// it.
/// Thread: that of the reception.
class Upstream {
 public:
  Upstream() = default;
  virtual ~Upstream() = default;
  Upstream(const Upstream&) = delete;
  Upstream& operator=(const Upstream&) = delete;

  [[nodiscard]] virtual Result<void> start() = 0;
  virtual void stop() = 0;
  /// The Reception of its stream.
  [[nodiscard]] virtual const Reception& reception() const = 0;
  /// Adds its state to `status`.
  virtual void describe(Status& status) const { status.upstreams.push_back(reception().status()); }
};

}  // namespace aucast::server
