#pragma once

#include <string_view>
#include <utility>

#include "common/sources/recording.h"

namespace aucast::sources {

/// The recording of one face in `text`; otherwise as read_faces().
[[nodiscard]] inline Result<Recording> read_recording(
    std::string_view text, std::string_view file, RecordingOptions options,
    const ConditioningSettings& conditioning = {},
    const LoadCurves& load_curves = load_arkit_table) {
  options.all_faces = false;
  auto faces = read_faces(text, file, options, conditioning, load_curves);
  if (!faces) return faces.error();
  return std::move(faces->front());
}

}  // namespace aucast::sources
