#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace aucast::mesh {

/// A picture that belongs to somebody else: rows from the top, three bytes RGB for each pixel.
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::span<const std::uint8_t> rgb;
};

/// A square in a picture, in pixels; it may be turned and reach beyond the picture.
struct Square {
  double x = 0;  ///< of its middle
  double y = 0;
  double side = 0;
  double turn_rad = 0;  ///< clockwise as one looks at it
};

/// Whether a square can be looked at: its numbers are numbers and nowhere near what an integer
/// holds, and its side is a pixel at least.
[[nodiscard]] bool can_be_seen(const Square& square);

/// Whether the middle of each lies well within the other: two squares around one face do.
[[nodiscard]] bool show_the_same(const Square& one, const Square& other);

/// What a square that can_be_seen() shows, `size` times `size` pixels, rows from its top: each byte
/// as a number from `low` to `high`, 0 bytes outside of the picture. Between pixels it is bilinear.
void sample_square(const Picture& picture, const Square& square, std::size_t size, float low,
                   float high, std::span<float> out);

}  // namespace aucast::mesh
