#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/playback/keyframe_list.h"
#include "common/result.h"

namespace aucast::app {

/// An animation to be exported with a face.
struct ExportedStream {
  playback::KeyframeList keyframes;  ///< empty: the face alone
  std::string name;
  std::string sound;  ///< name of the sound file that belongs to it; empty: none
};

/// Fails with BadData if a stream has more samples than can be exported. `place`: where the stream
/// was read from, for the message.
[[nodiscard]] Result<void> check_length(const playback::KeyframeList& keyframes,
                                        const PlayerOptions& options, const std::string& place);

/// Called for each finished sample of the animation, with the number of finished samples and the
/// total. Returns whether to go on.
using OnSample = std::function<bool(std::size_t done, std::size_t total)>;

/// Writes the face, with `stream` as its animation, into the GLB file that the options name.
/// Returns two lines: what the file contains, and how far its face is from the one that face-player
/// draws. If `on_sample` returns false, fails and writes nothing.
[[nodiscard]] Result<std::string> export_glb(const Assets& assets, const PlayerOptions& options,
                                             const ExportedStream& stream,
                                             const OnSample& on_sample = {});

}  // namespace aucast::app
