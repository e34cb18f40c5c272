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

/// How sources are read, both for serving and for converting.
struct SourceOptions {
  sources::RecordingOptions recording;
  std::optional<double> rate;  ///< keyframes a second, 0.1 to 1000; nullopt: as they are
  SignalOptions signal;
  camera::CameraOptions camera;
  friend bool operator==(const SourceOptions&, const SourceOptions&) = default;
};

/// The rows of recordings, from --rate to --face-id, bound to `options`.
[[nodiscard]] std::vector<OptionRow> recording_rows(SourceOptions& options);

/// The rows of cameras, --camera-size and --camera-fps, bound to `options`.
[[nodiscard]] std::vector<OptionRow> camera_rows(camera::CameraOptions& options);

/// The given options that have an effect only on tables, films and cameras, such as "--gain,
/// --neutral"; empty: there are none.
[[nodiscard]] std::string options_of_recordings(const SourceOptions& options);

/// How sources that are still being written are served.
struct LiveSourceSettings {
  bool follow = false;           ///< regular files too are read on as they grow
  Milliseconds timeout{10'000};  ///< after this silence a stream ends for its clients; 0: never
  friend bool operator==(const LiveSourceSettings&, const LiveSourceSettings&) = default;
};

}  // namespace aucast::server
