#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

namespace aucast {

/// The endings that a stream's sound file may have, in the order in which they are tried.
inline constexpr std::array<std::string_view, 5> kSoundEndings{".wav", ".flac", ".opus", ".ogg",
                                                               ".mp3"};

/// Whether a path names a sound file, by its ending.
[[nodiscard]] bool is_sound(const std::filesystem::path& path);

/// The sound file of the same name beside a stream file: that with the first of kSoundEndings that
/// exists; nullopt: none does.
[[nodiscard]] std::optional<std::filesystem::path> sound_beside(
    const std::filesystem::path& stream_file);

}  // namespace aucast
