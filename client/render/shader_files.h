#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast::render {

/// The texts of shaders/*.glsl, which are compiled into the program. To work on them, name a folder
/// in the environment variable AUCAST_SHADERS: the files in it are then read instead.
class ShaderFiles {
 public:
  ShaderFiles();

  /// Fails with Unreadable if the folder lacks the file.
  [[nodiscard]] Result<std::string> text(std::string_view name) const;

  /// Whether a file in the folder was written since the last call. Always false without a folder.
  [[nodiscard]] bool changed();

 private:
  std::filesystem::path folder_;  ///< empty: the compiled-in texts
  std::filesystem::file_time_type newest_ = std::filesystem::file_time_type::min();
};

}  // namespace aucast::render
