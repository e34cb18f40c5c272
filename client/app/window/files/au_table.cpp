#include "client/app/window/files/au_table.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace aucast::app {
namespace {

struct Column {
  std::size_t number;
  Side side;  ///< Both: the sides are equal in all keyframes
};

std::vector<Column> columns_of(const playback::KeyframeList& keyframes) {
  std::array<bool, kAuCount> occurs{};
  std::array<bool, kAuCount> sided{};
  for (const playback::Keyframe& keyframe : keyframes) {
    for (std::size_t number = 0; number < kAuCount; ++number) {
      const float left = keyframe.aus.left[number];
      const float right = keyframe.aus.right[number];
      occurs[number] |= left > 0 || right > 0;
      sided[number] |= left != right;
    }
  }
  std::vector<Column> columns;
  for (std::size_t number = 0; number < kAuCount; ++number) {
    if (!occurs[number]) continue;
    if (!sided[number]) {
      columns.push_back({number, Side::Both});
    } else {
      columns.push_back({number, Side::Left});
      columns.push_back({number, Side::Right});
    }
  }
  return columns;
}

/// Whole milliseconds.
std::string in_seconds(Milliseconds time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", static_cast<double>(time.count()) / 1000);
  return text.data();
}

}  // namespace

std::string format_au_table(const playback::KeyframeList& keyframes, Milliseconds untimed) {
  const std::vector<Column> columns = columns_of(keyframes);
  std::string text = "time_s,duration_s";
  for (const Column& column : columns) {
    text += ",AU" + std::to_string(column.number);
    if (column.side != Side::Both) text += column.side == Side::Left ? "_left" : "_right";
  }
  text += '\n';
  Milliseconds place{0};
  for (const playback::Keyframe& keyframe : keyframes) {
    const Milliseconds time = keyframe.time.value_or(untimed);
    place += time;
    text += in_seconds(place) + "," + in_seconds(time);
    for (const Column& column : columns) {
      const auto& side = column.side == Side::Right ? keyframe.aus.right : keyframe.aus.left;
      text += "," + std::to_string(percent_of(side[column.number]));
    }
    text += '\n';
  }
  return text;
}

}  // namespace aucast::app
