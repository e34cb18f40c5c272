#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace aucast::mesh {

/// A view of a picture that somebody else owns: rows from the top, three bytes RGB for each pixel.
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::span<const std::uint8_t> rgb;
};

/// A square in a picture, in pixels; it may be turned and reach beyond the picture.
struct Square {
  double x = 0;  ///< x of its middle
  double y = 0;
  double side = 0;
  double turn_rad = 0;  ///< clockwise as one looks at it
};

/// Whether a square can be sampled: its numbers are finite, small enough for integer pixels, and
/// its side is at least one pixel.
[[nodiscard]] bool can_be_seen(const Square& square);

/// Whether two squares seem to be around the same face: the middle of each lies well within the
/// other.
[[nodiscard]] bool show_the_same(const Square& one, const Square& other);

/// Samples a square bilinearly into `size` times `size` pixels, rows from its top. The square must
/// be one that can_be_seen(). Each byte becomes a number from `low` to `high`; outside of the
/// picture, bytes are taken as 0.
void sample_square(const Picture& picture, const Square& square, std::size_t size, float low,
                   float high, std::span<float> out);

}  // namespace aucast::mesh
