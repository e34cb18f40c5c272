#include "common/preview/preview_writer.h"

#include <algorithm>
#include <cmath>

#include "common/check.h"

namespace aucast::preview {
namespace {

void append_share(std::string& bytes, float share) {
  constexpr float kWhole = 65535;
  // What is not a number is 0 too.
  const float inside = share > 0 ? std::min(share, 1.0F) : 0;
  const auto value = static_cast<unsigned>(std::lround(inside * kWhole));
  bytes += static_cast<char>(value & 0xFFU);
  bytes += static_cast<char>(value >> 8U);
}

std::string text_of(const std::vector<AuTerm>& aus) {
  std::string text;
  for (const AuTerm& term : aus) {
    if (!text.empty()) text += ',';
    if (term.side != Side::Both) text += term.side == Side::Left ? 'L' : 'R';
    text += std::to_string(term.number) + ":" + std::to_string(term.percent);
  }
  return text;
}

}  // namespace

Seen small_picture(std::size_t width, std::size_t height, std::span<const std::uint8_t> rgb) {
  AUCAST_CHECK(width > 0 && height > 0 && rgb.size() == 3 * width * height);
  const std::size_t step = (std::max(width, height) + kSideMax - 1) / kSideMax;
  Seen seen;
  seen.width = std::max<std::size_t>(width / step, 1);
  seen.height = std::max<std::size_t>(height / step, 1);
  seen.rgb.reserve(3 * seen.width * seen.height);
  const std::size_t across = std::min(step, width);
  const std::size_t down = std::min(step, height);
  for (std::size_t y = 0; y < seen.height; ++y) {
    for (std::size_t x = 0; x < seen.width; ++x) {
      for (std::size_t colour = 0; colour < 3; ++colour) {
        std::size_t sum = 0;
        for (std::size_t row = y * step; row < y * step + down; ++row) {
          const std::uint8_t* pixel = &rgb[3 * (row * width + x * step) + colour];
          for (std::size_t i = 0; i < across; ++i) sum += pixel[3 * i];
        }
        seen.rgb.push_back(static_cast<std::uint8_t>(sum / (across * down)));
      }
    }
  }
  return seen;
}

std::string seen_record(const Seen& seen) {
  AUCAST_CHECK(seen.rgb.size() == 3 * seen.width * seen.height);
  const std::string aus = text_of(seen.aus);
  std::string record = "seen";
  for (const std::size_t number : {seen.width, seen.height, seen.points.size(), aus.size()}) {
    record += " " + std::to_string(number);
  }
  record += '\n';
  record.append(seen.rgb.begin(), seen.rgb.end());
  for (const Point& point : seen.points) {
    append_share(record, point.x);
    append_share(record, point.y);
  }
  return record + aus;
}

std::string live_record(std::string_view address) {
  return "live " + std::string(address) + "\n";
}

std::string private_record() {
  return "private\n";
}

std::string watching_record(std::size_t count) {
  return "watching " + std::to_string(count) + "\n";
}

std::string refused_record(std::string_view sentence) {
  std::string line = "refused " + std::string(sentence);
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line + "\n";
}

}  // namespace aucast::preview
