#include "server/streams/source_path.h"

#include <string_view>
#include <system_error>

namespace aucast::server {

std::string stream_name(const std::filesystem::path& path) {
  if (camera_device(path)) return "camera";
  return path == "-" ? "live" : path.stem().string();
}

std::optional<std::string> camera_device(const std::filesystem::path& path) {
  constexpr std::string_view kCamera = "camera";
  const std::string text = path.string();
  if (text == kCamera) return "/dev/video0";
  if (!text.starts_with("camera:") || text.size() == kCamera.size() + 1) return std::nullopt;
  return text.substr(kCamera.size() + 1);
}

std::string face_stream_name(const std::string& stem, std::int64_t face) {
  return stem + "-" + std::to_string(face);
}

bool is_live(const std::filesystem::path& path, bool follow) {
  if (path == "-" || camera_device(path)) return true;
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_regular_file(status)) return follow;
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status);
}

}  // namespace aucast::server
