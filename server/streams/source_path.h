#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace aucast::server {

/// The name of the stream that a source is served as: the file's stem; `live` for stdin, `camera`
/// for a camera.
[[nodiscard]] std::string stream_name(const std::filesystem::path& path);

/// The device of a camera, `camera` or `camera:DEVICE`; nothing for any other source.
[[nodiscard]] std::optional<std::string> camera_device(const std::filesystem::path& path);

/// The name of one face's stream with --face-id all: STEM-FACE.
[[nodiscard]] std::string face_stream_name(const std::string& stem, std::int64_t face);

/// Whether a path is a live source: stdin, a camera, a FIFO or another stream; and files, with
/// `follow`.
[[nodiscard]] bool is_live(const std::filesystem::path& path, bool follow);

}  // namespace aucast::server
