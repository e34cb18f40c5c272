#include "common/sources/found_report.h"

#include <array>
#include <charconv>
#include <utility>

#include "common/sources/profile.h"
#include "common/text.h"

namespace aucast::sources {
namespace {

/// "0-5", as people name such scales.
std::string scale_name(double scale) {
  return "0-" + std::to_string(static_cast<int>(scale));
}

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::fixed, digits);
  return written.ec == std::errc() ? std::string(text.data(), written.ptr) : "very much";
}

std::string line(std::string name, const std::string& value) {
  name.resize(12, ' ');
  return "  " + name + value + '\n';
}

std::string format_of(const Found& found) {
  return found.format + (found.note.empty() ? "" : " (" + found.note + ")");
}

std::string scale_of(const Found& found) {
  return scale_name(found.scale) + (found.scale_asked ? " as asked" : "") +
         (found.largest ? ", largest " + fixed(*found.largest, 2) : std::string());
}

/// The first few; a bad tracker may have thousands.
std::string faces_of(const Found& found) {
  constexpr std::size_t kShown = 8;
  std::string text = std::to_string(found.faces.size());
  for (std::size_t index = 0; index < found.faces.size() && index < kShown; ++index) {
    const Found::Face& face = found.faces[index];
    text += index == 0 ? ": " : ", ";
    text += "face " + std::to_string(face.id) + " in " + counted(face.rows, "row");
    if (face.id == found.face) text += found.all_taken ? " (this one)" : " (taken)";
  }
  return text + (found.faces.size() > kShown ? ", ..." : "");
}

/// The setting that would read the rows that were left out; empty when they are few.
std::string still_clock(const Found& found, const SettingNames& names) {
  if (found.left_out * 50 < found.rows || found.steps_a_second == 0) return {};
  return std::string(names.fps) + " " + fixed(found.steps_a_second, 0) + " reads them all";
}

std::string left_out_of(const Found& found) {
  const std::string text = std::to_string(found.left_out) + " left out (no later time)";
  const std::string remedy = still_clock(found, {});
  return remedy.empty() ? text : text + "; " + remedy;
}

/// Empty for a clock that a camera can have.
std::string hasty_clock(const Found& found, const SettingNames& names) {
  if (found.rows_a_second <= kRowsASecondMax) return {};
  return fixed(found.rows_a_second, 0) +
         " rows a second are no camera's: " + std::string(names.fps) + " says how many";
}

/// Empty if all values fit a scale.
std::string off_scale(const Found& found) {
  if (found.off_scale == 0) return {};
  return counted(found.off_scale, "AU value") + " above 100 left out, for no scale has them";
}

/// Empty for a neutral face.
std::string not_neutral_face(const Found& found, const SettingNames& names) {
  if (found.not_neutral.empty()) return {};
  const std::string neutral(names.neutral);
  return not_neutral_text(found.not_neutral) +
         (found.neutral_seconds
              ? "; " + neutral + " " + fixed(*found.neutral_seconds, 0) + " subtracts one"
              : "; leave out " + neutral + ", or cut what is before the face is neutral");
}

}  // namespace

std::vector<std::string> warnings(const Found& found, const SettingNames& names) {
  std::vector<std::string> all;
  const auto add = [&](std::string text) {
    if (!text.empty()) all.push_back(std::move(text));
  };
  add(hasty_clock(found, names));
  add(off_scale(found));
  if (const std::string remedy = still_clock(found, names); !remedy.empty()) {
    add(counted(found.left_out, "row") + " without a later time: " + remedy);
  }
  add(not_neutral_face(found, names));
  return all;
}

std::string found_lines(const Found& found) {
  std::string text = line("format", format_of(found));
  text += line("scale", scale_of(found));
  if (const std::string off = off_scale(found); !off.empty()) text += line("broken", off);
  text += line("people", faces_of(found));
  text += line("rows", std::to_string(found.rows) + ", " + std::to_string(found.lost) +
                           " of them no data, " + left_out_of(found));
  text += line("gaps", found.gaps == 0 ? "none over 0.5 s"
                                       : std::to_string(found.gaps) + " over 0.5 s, the longest " +
                                             fixed(found.gap_seconds_max, 2) + " s");
  if (const std::string clock = hasty_clock(found, {}); !clock.empty()) {
    text += line("clock", clock);
  }
  if (found.neutral) text += line("neutral", measured_text(*found.neutral));
  if (const std::string loud = not_neutral_face(found, {}); !loud.empty()) {
    text += line("not neutral", loud);
  }
  if (found.headers > 0) {
    text += line("appended", counted(found.headers, "header line") + " in the middle");
  }
  if (found.truncated) text += line("truncated", "the last line has no end and was left out");
  return text;
}

std::string found_sentence(const Found& found) {
  std::string text = format_of(found) + ", AU scale " + scale_of(found);
  if (found.faces.size() > 1) {
    text += ", face " + std::to_string(found.face) + " of " + std::to_string(found.faces.size());
  }
  if (found.lost > 0) {
    text += ", " + std::to_string(found.lost) + " of " + std::to_string(found.rows) +
            " rows without data";
  }
  if (found.left_out > 0) text += ", " + left_out_of(found);
  if (const std::string off = off_scale(found); !off.empty()) text += ", " + off;
  if (found.truncated) text += ", the truncated last line left out";
  if (const std::string clock = hasty_clock(found, {}); !clock.empty()) text += ", " + clock;
  if (found.neutral) text += ", neutral face " + measured_text(*found.neutral);
  if (const std::string loud = not_neutral_face(found, {}); !loud.empty()) text += ", " + loud;
  return text;
}

}  // namespace aucast::sources
