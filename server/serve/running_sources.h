#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <asio/io_context.hpp>

#include "common/camera/camera_feed.h"
#include "common/result.h"
#include "common/sources/conditioning.h"
#include "common/stopped.h"
#include "protocol/server_session.h"
#include "server/live/live_source.h"
#include "server/settings/transmitter_options.h"
#include "server/status/status.h"
#include "server/streams/live_thinning.h"
#include "server/upstream/upstream.h"

namespace aucast::server {

/// The limits on what one client of a live stream is sent.
[[nodiscard]] LinkLimits link_limits(const TransmitterOptions& options);

/// The sources whose streams arrive while they are served: those that are still being written, and
/// streams of other servers. Thread: that of the io_context. The io_context, the options and what
/// the events capture must outlive this object.
class RunningSources {
 public:
  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new, or has ended
    std::function<void()> on_face;    ///< a source has another stream
    camera::OnSight on_sight{};       ///< a camera sees something, on its own thread
  };

  /// `id`: of this server, by which relays notice if their own streams come back. `take_name` is
  /// called when a stream gets a name that was not known at the start.
  RunningSources(asio::io_context& io, const TransmitterOptions& options, std::string id,
                 RelayedStream::TakeName take_name, Events events);
  RunningSources(const RunningSources&) = delete;
  RunningSources& operator=(const RunningSources&) = delete;

  /// Opens the options' sources of these kinds. While it waits for a camera it asks `given_up`.
  [[nodiscard]] Result<void> open(const GivenUp& given_up = {});
  void stop();

  /// Whether nothing more can come from any of them; true if there are none.
  [[nodiscard]] bool over() const;
  [[nodiscard]] std::vector<protocol::ServedStream> streams() const;
  /// Uses other settings for the signals of live sources from their next rows on, if the options
  /// have a profile, which is the only thing that can have changed.
  void condition(const sources::ConditioningSettings& settings);
  /// Fills in everything about streams of other servers.
  void describe(Status& status) const;
  /// Waits until the records and the profile of --save-profile are written. If a live source had an
  /// error that did not end it, fails with that error.
  [[nodiscard]] Result<void> finish();

 private:
  [[nodiscard]] Result<LiveStreamOptions> stream_options(const std::filesystem::path& path,
                                                         bool voice) const;
  [[nodiscard]] Result<void> open_live(const std::filesystem::path& path, const GivenUp& given_up);
  [[nodiscard]] Result<void> open_dialled(const std::string& address);
  [[nodiscard]] Result<void> open_edge(const std::string& address);
  [[nodiscard]] Reception::Options reception(const std::string& name, const char* sender) const;
  [[nodiscard]] Result<void> begin(std::unique_ptr<Upstream> upstream);
  void on_neutral(const sources::MeasuredNeutral& neutral);

  asio::io_context& io_;
  const TransmitterOptions& options_;
  const std::string id_;
  const RelayedStream::TakeName take_name_;
  Events events_;
  sources::ConditioningSettings conditioning_;  ///< of live sources
  std::vector<std::unique_ptr<LiveSource>> live_;
  std::vector<std::unique_ptr<Upstream>> upstreams_;
  std::jthread saving_;  ///< writes the profile of --save-profile
};

}  // namespace aucast::server
