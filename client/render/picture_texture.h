#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "client/render/gl_objects.h"
#include "client/view/image.h"

namespace aucast::render {

/// A picture that is drawn as it is and may be replaced at any time. The context must be current
/// whenever it is used.
class PictureTexture {
 public:
  /// `rgb`: 3 * width * height bytes, top row first. Neither width nor height may be 0.
  void show(std::size_t width, std::size_t height, std::span<const std::uint8_t> rgb);
  /// Alpha is ignored. The picture must not be empty.
  void show(const view::Image& image);
  [[nodiscard]] GLuint id() const { return texture_.id(); }

 private:
  void upload(std::size_t width, std::size_t height, GLenum format, const std::uint8_t* bytes);

  Texture texture_;
};

}  // namespace aucast::render
