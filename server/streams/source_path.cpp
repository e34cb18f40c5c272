#include "server/streams/source_path.h"

#include <system_error>

namespace aucast::server {

std::string stream_name(const std::filesystem::path& path) {
  return path == "-" ? "live" : path.stem().string();
}

std::string face_stream_name(const std::string& stem, std::int64_t face) {
  return stem + "-" + std::to_string(face);
}

bool is_live(const std::filesystem::path& path, bool follow) {
  if (path == "-") return true;
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_regular_file(status)) return follow;
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status);
}

}  // namespace aucast::server
