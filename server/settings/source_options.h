#pragma once

#include <optional>
#include <vector>

#include "common/camera/picture_source.h"
#include "common/options.h"
#include "common/result.h"
#include "common/sources/recording.h"
#include "common/time.h"
#include "server/settings/signal_options.h"

namespace aucast::server {

/// How sources are read, whatever is done with them then.
struct SourceOptions {
  sources::RecordingOptions recording;
  std::optional<double> rate;  ///< keyframes a second, 0.1 to 1000; nothing: as they are
  SignalOptions signal;
  camera::CameraOptions camera;
  friend bool operator==(const SourceOptions&, const SourceOptions&) = default;
};

/// The options of recordings, bound to `options`: --rate to --face-id.
[[nodiscard]] std::vector<OptionRow> recording_rows(SourceOptions& options);

/// The options of cameras, bound to `options`: --camera-size and --camera-fps.
[[nodiscard]] std::vector<OptionRow> camera_rows(camera::CameraOptions& options);

/// How sources that are still being written are served.
struct LiveSourceSettings {
  bool follow = false;           ///< files too
  Milliseconds timeout{10'000};  ///< a silent one ends for its clients; 0: never
  friend bool operator==(const LiveSourceSettings&, const LiveSourceSettings&) = default;
};

}  // namespace aucast::server
