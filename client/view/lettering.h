#pragma once

#include <cstdint>
#include <string_view>

#include "client/view/image.h"

namespace aucast::view {

/// The width of a line of text in pixels if its capitals are `cap_height` pixels high.
[[nodiscard]] int text_width(std::string_view text, int cap_height);

/// Draws a line of printable ASCII in the font Inter, which is compiled into the program; other
/// bytes become question marks. (x, y) is the top left corner of the first capital. What lies
/// outside the picture is clipped.
void draw_text(Image& image, int x, int y, std::string_view text, int cap_height,
               std::uint32_t rgb);

}  // namespace aucast::view
