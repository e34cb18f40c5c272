#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/io_context.hpp>

#include "common/camera/camera_feed.h"
#include "common/result.h"
#include "common/sources/conditioning.h"
#include "protocol/server_session.h"
#include "server/live/live_source.h"
#include "server/settings/transmitter_options.h"
#include "server/status/status.h"
#include "server/streams/live_thinning.h"
#include "server/upstream/upstream.h"

namespace aucast::server {

/// What one client of a live stream may be sent.
[[nodiscard]] LinkLimits link_limits(const TransmitterOptions& options);

/// The sources whose streams come while they are served: those that are still being written, and
/// streams of other servers. Thread: that of the io_context, which must outlive it together with
/// the events' captures and the options.
class RunningSources {
 public:
  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new, or has ended
    std::function<void()> on_face;    ///< a source has a stream more
    camera::OnSight on_sight{};       ///< a camera sees something, on its own thread
    camera::GivenUp given_up{};       ///< while open() waits for a camera
  };

  /// `id`: of this server, by which relays find loops.
  RunningSources(asio::io_context& io, const TransmitterOptions& options, std::string id,
                 Events events);
  RunningSources(const RunningSources&) = delete;
  RunningSources& operator=(const RunningSources&) = delete;

  /// Opens those among the options' sources.
  [[nodiscard]] Result<void> open();
  void stop();

  [[nodiscard]] bool any() const { return !live_.empty() || !upstreams_.empty(); }
  /// Nothing can come of any of them; also if there are none.
  [[nodiscard]] bool over() const;
  [[nodiscard]] std::vector<protocol::ServedStream> streams() const;
  /// The profile of the signals may have changed: reads it again.
  void condition_anew();
  /// Fills in what `status` says of streams of other servers.
  void describe(Status& status) const;
  /// What went wrong with those that are being written without stopping anything. Waits until the
  /// records are written.
  [[nodiscard]] Result<void> finish();

 private:
  [[nodiscard]] Result<void> open_live(const std::filesystem::path& path,
                                       const sources::ConditioningSettings& conditioning);
  [[nodiscard]] Result<void> open_dialled(const std::string& address);
  [[nodiscard]] Result<void> open_edge(const std::string& address);
  [[nodiscard]] Reception::Options reception(const std::string& name, const char* sender) const;
  [[nodiscard]] Result<void> begin(std::unique_ptr<Upstream> upstream);
  void on_neutral(const sources::MeasuredNeutral& neutral) const;

  asio::io_context& io_;
  const TransmitterOptions& options_;
  const std::string id_;
  Events events_;
  std::vector<std::unique_ptr<LiveSource>> live_;
  std::vector<std::unique_ptr<Upstream>> upstreams_;
};

}  // namespace aucast::server
