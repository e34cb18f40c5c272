#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"

namespace aucast::app {

/// An animation to be exported with a face.
struct ExportedStream {
  std::vector<playback::Keyframe> keyframes;  ///< none: the face alone
  std::string name;
  std::string sound;  ///< the file that belongs to it; empty: none
};

/// BadData when a stream has more samples than are exported; `place` is what it was read from.
[[nodiscard]] Result<void> check_length(const std::vector<playback::Keyframe>& keyframes,
                                        const PlayerOptions& options, const std::string& place);

/// Called for each finished sample of the animation, with the number of all; returns whether to go
/// on.
using OnSample = std::function<bool(std::size_t done, std::size_t total)>;

/// Writes the face, and the animation that a stream gives it, as the GLB file of the options.
/// Returns what is in it and how far it is from the face that face-player draws, in two lines.
/// Stopped by `on_sample` it fails and writes nothing.
[[nodiscard]] Result<std::string> export_glb(const Assets& assets, const PlayerOptions& options,
                                             const ExportedStream& stream,
                                             const OnSample& on_sample = {});

}  // namespace aucast::app
