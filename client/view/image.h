#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "client/view/png_text.h"
#include "common/result.h"

namespace aucast::view {

/// An sRGB picture, 8 bits, RGBA, top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height
};

[[nodiscard]] Image make_image(int width, int height, std::uint32_t rgb = 0);

/// The picture as the bytes of a PNG file. Fails if there is not enough memory.
[[nodiscard]] Result<std::string> png_bytes(const Image& image);
/// Writes a PNG atomically, with these texts. Fails if the file cannot be written there.
[[nodiscard]] Result<void> write_png(const Image& image, const std::filesystem::path& path,
                                     std::span<const PngText> texts = {});
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& path);

/// Copies `from` into `to` with its top left corner at (x, y), clipped at the borders.
void paste(Image& to, const Image& from, int x, int y);

/// The picture at half its width and height, which must both be even: each pixel is the mean of
/// four. stb_image_resize gives the same bytes, but takes eighty times as long.
[[nodiscard]] Image halved(const Image& image);

/// The picture with a transparent background, made from the same picture on black and on white:
/// alpha = 1 - (white - black), colour = black / alpha (Smith and Blinn 1996, two backings).
[[nodiscard]] Image without_ground(const Image& on_black, const Image& on_white);

/// Puts pictures of one size into rows of `columns`, each with a line of text under it, on a plain
/// background.
[[nodiscard]] Image contact_sheet(std::span<const Image> pictures,
                                  std::span<const std::string> captions, int columns);

}  // namespace aucast::view
