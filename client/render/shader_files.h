#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast::render {

/// The texts of shaders/*.glsl. They are part of the program; for work on them the environment
/// variable AUCAST_SHADERS names a folder that is read instead.
class ShaderFiles {
 public:
  ShaderFiles();

  /// Unreadable when the folder lacks the file.
  [[nodiscard]] Result<std::string> text(std::string_view name) const;

  /// Whether a file of the folder was written since the last call; never without a folder.
  [[nodiscard]] bool changed();

 private:
  std::filesystem::path folder_;  ///< empty: the texts of the program
  std::filesystem::file_time_type newest_ = std::filesystem::file_time_type::min();
};

}  // namespace aucast::render
