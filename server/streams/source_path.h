#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace aucast::server {

/// The name of a source's stream: the file's stem; `live` for stdin, `camera` for a camera.
[[nodiscard]] std::string stream_name(const std::filesystem::path& path);

/// The device of a camera, which is written `camera` or `camera:DEVICE`; nullopt for any other
/// source.
[[nodiscard]] std::optional<std::string> camera_device(const std::filesystem::path& path);

/// The name of one face's stream with --face-id all: STEM-FACE.
[[nodiscard]] std::string face_stream_name(const std::string& stem, std::int64_t face);

/// Whether a path is a live source: stdin, a camera, a FIFO or the like; with `follow`, also a
/// regular file.
[[nodiscard]] bool is_live(const std::filesystem::path& path, bool follow);

}  // namespace aucast::server
