#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/preview/seen.h"

namespace aucast::preview {

/// Shrinks the picture by whole factors until no side exceeds kSideMax; fills width, height and rgb
/// only. `rgb` has 3 * width * height bytes; neither side is 0.
[[nodiscard]] Seen small_picture(std::size_t width, std::size_t height,
                                 std::span<const std::uint8_t> rgb);

/// The record for a picture from small_picture(). Points outside of it are moved to its edge.
[[nodiscard]] std::string seen_record(const Seen& seen);
/// "live ADDR:PORT"
[[nodiscard]] std::string live_record(std::string_view address);
[[nodiscard]] std::string private_record();
[[nodiscard]] std::string watching_record(std::size_t count);
/// The record for a refusal, with the sentence in one line.
[[nodiscard]] std::string refused_record(std::string_view sentence);

}  // namespace aucast::preview
