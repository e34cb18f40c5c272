#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace aucast {

/// The endings of sound files that belong to a stream, in the order in which they are looked for.
inline constexpr std::array<std::string_view, 5> kSoundEndings{".wav", ".flac", ".opus", ".ogg",
                                                               ".mp3"};

/// Whether a path names a sound file, by its ending.
[[nodiscard]] bool is_sound(const std::filesystem::path& path);

}  // namespace aucast
