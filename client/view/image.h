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

/// The bytes of a PNG file. Failed when there is not enough memory.
[[nodiscard]] Result<std::string> png_bytes(const Image& image);
/// Writes a PNG atomically, with these texts. Failed when the place cannot be written.
[[nodiscard]] Result<void> write_png(const Image& image, const std::filesystem::path& path,
                                     std::span<const PngText> texts = {});
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& path);

/// Copies `from` into `to` with its top left corner at (x, y), clipped at the borders.
void paste(Image& to, const Image& from, int x, int y);

/// Half as wide and high, both of which are even: each pixel the mean of four. stb_image_resize
/// gives the same bytes in eighty times the time.
[[nodiscard]] Image halved(const Image& image);

/// The picture whose ground is transparent, from the same picture on black and on white ground:
/// alpha = 1 - (white - black), colour = black / alpha (Smith and Blinn 1996, two backings).
[[nodiscard]] Image without_ground(const Image& on_black, const Image& on_white);

/// Pictures of one size in rows of `columns`, each with a line of text under it, on a plain ground.
[[nodiscard]] Image contact_sheet(std::span<const Image> pictures,
                                  std::span<const std::string> captions, int columns);

}  // namespace aucast::view
