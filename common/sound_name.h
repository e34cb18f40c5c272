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

/// The file of the same name beside a source, which belongs to it as subtitles belong to a film:
/// the source's path with another `ending`; nullopt: there is none, or it is a folder. A link to
/// nowhere is found, so that whoever reads it says what is wrong.
[[nodiscard]] std::optional<std::filesystem::path> file_beside(const std::filesystem::path& source,
                                                               std::string_view ending);

/// The sound file beside a source: that with the first of kSoundEndings that is there; nullopt:
/// none is.
[[nodiscard]] std::optional<std::filesystem::path> sound_beside(
    const std::filesystem::path& source);

}  // namespace aucast
