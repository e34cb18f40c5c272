#pragma once

#include <filesystem>
#include <string>

#include "client/gui/editing/composer.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"

namespace aucast::app {

/// Turns a keyframe that was read or received into one of the composer.
[[nodiscard]] gui::ComposedKeyframe composed(const playback::Keyframe& keyframe);

/// The text of a stream file with these keyframes and `title`, if that is not empty. It is checked
/// by reading it back. Fails if there is no keyframe.
[[nodiscard]] Result<std::string> stream_text(const gui::Composer::Keyframes& keyframes,
                                              const std::string& title = {});

/// Writes that text, completely or not at all, and returns a sentence about where it was saved. If
/// the file had another text, which may have comments, the old file is kept with a ~ at the end of
/// its name.
[[nodiscard]] Result<std::string> save_stream(const gui::Composer::Keyframes& keyframes,
                                              const std::filesystem::path& file,
                                              const std::string& title = {});

}  // namespace aucast::app
