#include "common/camera/y4m.h"

#include <algorithm>
#include <utility>

#include "common/number_of.h"
#include "common/text.h"

namespace aucast::camera {
namespace {

constexpr std::size_t kLineMax = 256;

std::uint8_t byte_of(int number) {
  return static_cast<std::uint8_t>(std::clamp((number + 128) >> 8, 0, 255));
}

/// BT.601 with luma from 16 to 235, in 256ths.
void to_rgb(int y, int cb, int cr, std::uint8_t* rgb) {
  const int light = 298 * (y - 16);
  const int blue = cb - 128;
  const int red = cr - 128;
  rgb[0] = byte_of(light + 409 * red);
  rgb[1] = byte_of(light - 100 * blue - 208 * red);
  rgb[2] = byte_of(light + 516 * blue);
}

std::optional<double> ratio_of(std::string_view word) {
  const auto parts = split(word, ':');
  if (parts.size() != 2) return std::nullopt;
  const auto above = number_of<std::uint32_t>(parts[0]);
  const auto below = number_of<std::uint32_t>(parts[1]);
  if (!above || !below || *above == 0 || *below == 0) return std::nullopt;
  return double{*above * 1.0} / *below;
}

}  // namespace

Result<std::optional<Y4mReader>> Y4mReader::open(Read read) {
  Y4mReader reader;
  reader.read_ = std::move(read);
  const auto line = reader.line();
  if (!line) return std::optional<Y4mReader>();
  if (!reader.parse(*line)) {
    return Error{ErrorKind::BadData, "not the pictures that were asked for: " + escaped(*line)};
  }
  reader.planes_.resize(3 * reader.width_ * reader.height_);
  return std::optional<Y4mReader>(std::move(reader));
}

bool Y4mReader::parse(std::string_view line) {
  const auto words = split(line, ' ');
  if (words[0] != "YUV4MPEG2") return false;
  bool colours = false;
  for (const std::string_view word : words) {
    if (word.empty()) continue;
    const std::string_view value = word.substr(1);
    if (word[0] == 'W') width_ = number_of<std::size_t>(value).value_or(0);
    if (word[0] == 'H') height_ = number_of<std::size_t>(value).value_or(0);
    if (word[0] == 'F') fps_ = ratio_of(value).value_or(0);
    if (word[0] == 'C') colours = value == "444";
  }
  const auto possible = [](std::size_t side) { return side >= 1 && side <= kSideMax; };
  return possible(width_) && possible(height_) && fps_ > 0 && colours;
}

std::optional<std::string> Y4mReader::line() {
  std::string text;
  std::uint8_t byte = 0;
  while (text.size() < kLineMax && read_({&byte, 1}) == 1) {
    if (byte == '\n') return text;
    text += static_cast<char>(byte);
  }
  if (text.empty()) return std::nullopt;
  return text;
}

bool Y4mReader::fill(std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const std::size_t got = read_(bytes);
    if (got == 0) return false;
    bytes = bytes.subspan(got);
  }
  return true;
}

bool Y4mReader::next(std::vector<std::uint8_t>& rgb) {
  const auto head = line();
  if (!head) return false;
  torn_ = !head->starts_with("FRAME") || !fill(planes_);
  if (torn_) return false;
  const std::size_t count = width_ * height_;
  rgb.resize(3 * count);
  const std::uint8_t* planes = planes_.data();
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    to_rgb(planes[pixel], planes[count + pixel], planes[2 * count + pixel], &rgb[3 * pixel]);
  }
  return true;
}

}  // namespace aucast::camera
