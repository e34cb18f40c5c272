#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"

namespace aucast::camera {

/// Reads uncompressed pictures as ffmpeg and others pipe them (YUV4MPEG2): a line with their size
/// and rate, then picture after picture. Supports only what we ask ffmpeg for: 4:4:4, 8 bit, BT.601
/// in video range. Pure: bytes come from `read`.
class Y4mReader {
 public:
  /// Fills the span or a part of it and returns how many bytes it read; 0 at the end.
  using Read = std::function<std::size_t(std::span<std::uint8_t>)>;

  /// Fails with BadData and a message without a place if the first line is not of this format.
  /// Returns nullopt if there are no bytes at all.
  [[nodiscard]] static Result<std::optional<Y4mReader>> open(Read read);

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t height() const { return height_; }
  /// Pictures a second, above 0.
  [[nodiscard]] double fps() const { return fps_; }
  /// Reads the next picture into `rgb`, rows from the top. Returns false at the end. A picture that
  /// is cut off is left out.
  [[nodiscard]] bool next(std::vector<std::uint8_t>& rgb);
  /// Whether the end came in the middle of a picture.
  [[nodiscard]] bool torn() const { return torn_; }

  static constexpr std::size_t kSideMax = 4096;

 private:
  Y4mReader() = default;
  [[nodiscard]] bool parse(std::string_view line);
  [[nodiscard]] std::optional<std::string> line();
  [[nodiscard]] bool fill(std::span<std::uint8_t> bytes);

  Read read_;
  std::size_t width_ = 0;
  std::size_t height_ = 0;
  double fps_ = 0;
  std::vector<std::uint8_t> planes_;
  bool torn_ = false;
};

}  // namespace aucast::camera
