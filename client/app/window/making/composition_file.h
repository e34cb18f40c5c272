#pragma once

#include <filesystem>
#include <string>

#include "client/gui/composer.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"

namespace aucast::app {

/// A keyframe that was read or received, as the composer has them.
[[nodiscard]] gui::ComposedKeyframe composed(const playback::Keyframe& keyframe);

/// The text of a stream file with these keyframes, read back by the same reader before it is handed
/// out. Failed when there is none.
[[nodiscard]] Result<std::string> stream_text(const gui::Composer::Keyframes& keyframes);

/// Writes that text whole or not at all and returns a sentence about where it went. A file that
/// says something else stays beside it with a ~ at its end, because it may have comments.
[[nodiscard]] Result<std::string> save_stream(const gui::Composer::Keyframes& keyframes,
                                              const std::filesystem::path& file);

}  // namespace aucast::app
