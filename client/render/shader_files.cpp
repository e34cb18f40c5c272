#include "client/render/shader_files.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "common/check.h"
#include "common/embedded_file.h"
#include "common/files.h"

namespace aucast::render {

ShaderFiles::ShaderFiles() {
  if (const char* folder = std::getenv("AUCAST_SHADERS")) folder_ = folder;
  static_cast<void>(changed());
}

Result<std::string> ShaderFiles::text(std::string_view name) const {
  if (!folder_.empty()) return read_file(folder_ / name);
  for (const auto& file : embedded::shaders()) {
    if (file.name == name) return std::string(file.bytes);
  }
  AUCAST_CHECK(false);
  return std::string();
}

bool ShaderFiles::changed() {
  if (folder_.empty()) return false;
  auto newest = newest_;
  for (const auto& file : embedded::shaders()) {
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(folder_ / file.name, missing);
    if (!missing) newest = std::max(newest, written);
  }
  return std::exchange(newest_, newest) != newest;
}

}  // namespace aucast::render
