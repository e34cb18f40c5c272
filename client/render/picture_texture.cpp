#include "client/render/picture_texture.h"

#include "common/check.h"

namespace aucast::render {

void PictureTexture::show(std::size_t width, std::size_t height,
                          std::span<const std::uint8_t> rgb) {
  AUCAST_CHECK(rgb.size() == 3 * width * height);
  upload(width, height, GL_RGB, rgb.data());
}

void PictureTexture::show(const view::Image& image) {
  upload(static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height), GL_RGBA,
         image.rgba.data());
}

void PictureTexture::upload(std::size_t width, std::size_t height, GLenum format,
                            const std::uint8_t* bytes) {
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, static_cast<GLsizei>(width), static_cast<GLsizei>(height),
               0, format, GL_UNSIGNED_BYTE, bytes);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace aucast::render
