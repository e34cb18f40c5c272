#include "client/view/image.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "client/view/lettering.h"
#include "common/check.h"
#include "common/files.h"
#include "common/text.h"

namespace aucast::view {
namespace {

constexpr int kChannels = 4;

std::size_t index_of(const Image& image, int x, int y) {
  return kChannels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x));
}

bool whole(const Image& image) {
  return image.width > 0 && image.height > 0 &&
         image.rgba.size() == index_of(image, 0, image.height);
}

bool opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += kChannels) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / kChannels * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += kChannels) {
    rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  }
  return rgb;
}

/// The caption, cut short with dots if it is too wide.
std::string fitting(std::string caption, int width, int cap_height) {
  if (text_width(caption, cap_height) <= width) return caption;
  while (!caption.empty() && text_width(caption + "...", cap_height) > width) caption.pop_back();
  return caption + "...";
}

}  // namespace

Image make_image(int width, int height, std::uint32_t rgb) {
  AUCAST_CHECK(width > 0);
  AUCAST_CHECK(height > 0);
  Image image{width, height, {}};
  image.rgba.resize(index_of(image, 0, height));
  for (std::size_t i = 0; i < image.rgba.size(); i += kChannels) {
    image.rgba[i] = static_cast<std::uint8_t>((rgb >> 16U) & 255U);
    image.rgba[i + 1] = static_cast<std::uint8_t>((rgb >> 8U) & 255U);
    image.rgba[i + 2] = static_cast<std::uint8_t>(rgb & 255U);
    image.rgba[i + 3] = 255;
  }
  return image;
}

Result<std::string> png_bytes(const Image& image) {
  AUCAST_CHECK(whole(image));
  // A third less to compress, and every viewer shows it the same.
  const bool drop_alpha = opaque(image);
  const std::vector<std::uint8_t> rgb =
      drop_alpha ? without_alpha(image) : std::vector<std::uint8_t>{};
  const int channels = drop_alpha ? 3 : kChannels;
  const auto append = [](void* bytes, void* data, int size) {
    static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                             static_cast<std::size_t>(size));
  };
  std::string bytes;
  const int done =
      stbi_write_png_to_func(append, &bytes, image.width, image.height, channels,
                             drop_alpha ? rgb.data() : image.rgba.data(), image.width * channels);
  if (done == 0) return Error{ErrorKind::Failed, "no memory for a picture"};
  return bytes;
}

Result<void> write_png(const Image& image, const std::filesystem::path& path,
                       std::span<const PngText> texts) {
  const auto bytes = png_bytes(image);
  if (!bytes) return Error{bytes.error().kind, at_place(path.string(), bytes.error().message)};
  return write_file_atomically(path, with_texts(*bytes, texts));
}

Result<Image> read_png(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes.has_value()) return bytes.error();
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes->data()),
                            static_cast<int>(bytes->size()), &image.width, &image.height, &channels,
                            kChannels),
      &stbi_image_free);
  if (pixels == nullptr) {
    const char* reason = stbi_failure_reason();
    return Error{
        ErrorKind::BadData,
        at_place(path.string(), std::string("not a PNG picture that can be read (") +
                                    (reason == nullptr ? "no reason given" : reason) + ")")};
  }
  image.rgba.assign(pixels.get(), pixels.get() + index_of(image, 0, image.height));
  return image;
}

void paste(Image& to, const Image& from, int x, int y) {
  const int first_column = std::max(0, -x);
  const int columns = std::min(from.width, to.width - x) - first_column;
  if (columns <= 0) return;
  for (int row = std::max(0, -y); row < std::min(from.height, to.height - y); ++row) {
    std::memcpy(&to.rgba[index_of(to, x + first_column, y + row)],
                &from.rgba[index_of(from, first_column, row)],
                static_cast<std::size_t>(columns) * kChannels);
  }
}

Image contact_sheet(std::span<const Image> pictures, std::span<const std::string> captions,
                    int columns) {
  constexpr std::uint32_t kGround = 0xf4f4f2;
  constexpr std::uint32_t kInk = 0x2a2d31;
  AUCAST_CHECK(!pictures.empty());
  AUCAST_CHECK(pictures.size() == captions.size());
  AUCAST_CHECK(columns > 0);
  const int width = pictures.front().width;
  const int height = pictures.front().height;
  const int count = static_cast<int>(pictures.size());
  const int across = std::min(columns, count);
  const int down = (count + across - 1) / across;
  const int cap_height = std::clamp(width / 26, 9, 24);
  const int gap = cap_height;
  const int caption_height = 3 * cap_height;
  Image sheet =
      make_image(gap + across * (width + gap), gap + down * (height + caption_height), kGround);
  for (int i = 0; i < count; ++i) {
    const Image& picture = pictures[static_cast<std::size_t>(i)];
    AUCAST_CHECK(whole(picture));
    AUCAST_CHECK(picture.width == width && picture.height == height);
    const int x = gap + i % across * (width + gap);
    const int y = gap + i / across * (height + caption_height);
    paste(sheet, picture, x, y);
    const std::string caption = fitting(captions[static_cast<std::size_t>(i)], width, cap_height);
    draw_text(sheet, x + (width - text_width(caption, cap_height)) / 2,
              y + height + cap_height * 3 / 4, caption, cap_height, kInk);
  }
  return sheet;
}

Image halved(const Image& image) {
  AUCAST_CHECK(whole(image));
  AUCAST_CHECK(image.width % 2 == 0 && image.height % 2 == 0);
  Image half{image.width / 2, image.height / 2, {}};
  half.rgba.resize(index_of(half, 0, half.height));
  const std::size_t row = index_of(image, 0, 1);
  for (int y = 0; y < half.height; ++y) {
    std::uint8_t* to = &half.rgba[index_of(half, 0, y)];
    const std::uint8_t* from = &image.rgba[index_of(image, 0, 2 * y)];
    for (int x = 0; x < half.width; ++x, from += 2 * kChannels) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        const int sum = from[c] + from[c + kChannels] + from[c + row] + from[c + row + kChannels];
        *to++ = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

Image without_ground(const Image& on_black, const Image& on_white) {
  AUCAST_CHECK(whole(on_black) && on_black.rgba.size() == on_white.rgba.size());
  Image image{on_black.width, on_black.height, {}};
  image.rgba.resize(on_black.rgba.size());
  for (std::size_t i = 0; i < image.rgba.size(); i += kChannels) {
    const std::uint8_t* const black = &on_black.rgba[i];
    const std::uint8_t* const white = &on_white.rgba[i];
    // Where the ground shines through, it does so in all three colours alike, but for rounding.
    const int through = (white[0] - black[0] + white[1] - black[1] + white[2] - black[2] + 1) / 3;
    const int alpha = 255 - std::clamp(through, 0, 255);
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c) {
      image.rgba[i + c] =
          static_cast<std::uint8_t>(std::min(255, (black[c] * 255 + alpha / 2) / alpha));
    }
    image.rgba[i + 3] = static_cast<std::uint8_t>(alpha);
  }
  return image;
}

}  // namespace aucast::view
