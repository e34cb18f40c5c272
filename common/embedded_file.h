#pragma once

#include <span>
#include <string_view>

namespace aucast::embedded {

/// A file of the sources that the build made part of the program (CMake: aucast_embed).
struct EmbeddedFile {
  std::string_view name;  ///< without its folder
  std::string_view bytes;
};

[[nodiscard]] std::span<const EmbeddedFile> fonts();
[[nodiscard]] std::span<const EmbeddedFile> gallery_styles();
[[nodiscard]] std::span<const EmbeddedFile> shaders();

}  // namespace aucast::embedded
