#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/au_numbers.h"
#include "common/sources/clock_text.h"
#include "common/sources/format.h"

namespace aucast::sources {
namespace {

constexpr double kSecondsPerDay = 86'400;
/// Frames of a timecode a second, as Live Link Face counts them.
constexpr double kUsualRate = 60;

std::string pascal_case(std::string name) {
  if (!name.empty() && name.front() >= 'a' && name.front() <= 'z') {
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
  }
  return name;
}

/// The column of a curve: Live Link Face writes JawOpen, everybody else jawOpen.
std::optional<std::size_t> curve_column(const CsvReader& table, const std::string& name) {
  const auto column = table.column(name);
  return column ? column : table.column(pascal_case(name));
}

std::optional<std::size_t> first_column(const CsvReader& table,
                                        std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    if (const auto column = table.column(name)) return column;
  }
  return std::nullopt;
}

/// A column of times whose unit no name says. No camera takes 5 s for a picture, and no recording
/// begins at a whole second above 5.
class Times {
 public:
  Times() = default;
  explicit Times(const CsvReader& table)
      : column_(first_column(table, {"timestamp", "Timestamp", "timestamp_ms", "timestampMs",
                                     "time", "Time", "time_ms", "time_s", "seconds"})) {
    const std::string_view name = column_ ? table.columns()[*column_] : std::string_view();
    if (name.ends_with("_ms") || name.ends_with("Ms")) unit_ = kMilli;
  }

  void scan(CsvReader& row) {
    const auto time = row.number(column_);
    if (!time) return;
    if (!first_) {
      first_ = *time;
      const bool whole = row.text(column_).find('.') == std::string_view::npos;
      if (whole && *time > kStepMax) unit_ = kMilli;
    } else if (*time - *first_ > kStepMax && !told_) {
      unit_ = kMilli;
    }
    told_ = told_ || *time != *first_;
  }

  [[nodiscard]] std::optional<double> read(CsvReader& row) const {
    const auto time = row.number(column_);
    if (!time) return std::nullopt;
    return *time * unit_;
  }

 private:
  static constexpr double kMilli = 1e-3;
  static constexpr double kStepMax = 5;

  std::optional<std::size_t> column_;
  std::optional<double> first_;
  bool told_ = false;  ///< by a second time
  double unit_ = 1;
};

/// ARKit's 52 curves, or MediaPipe's, which have the same names: as Live Link Face for iPhone
/// records them, or as tables with or without a column of pictures or times before them. Curves are
/// bound by name: JawRight and MouthRight come before Left in Live Link Face's file, after it in
/// Unreal's own order. Eye angles are radians, positive to the subject's right and down (checked
/// against EyeLookIn, Out, Up and Down). The head's are taken to have the same signs; they are all
/// 0 unless the app was told to stream them. The frames of a timecode count at a rate of their own,
/// 60 a second even in a take of 30 pictures a second.
class Arkit final : public Format {
 public:
  Arkit(const CsvReader& table, const ArkitTable& curves);

  [[nodiscard]] std::string_view name() const override {
    return timecode_ || count_ ? "Live Link Face" : "ARKit curves";
  }
  [[nodiscard]] double native_scale() const override { return 1; }
  [[nodiscard]] std::string note() const override {
    return "curves read as AUs by a table, approximate";
  }
  void scan(CsvReader& row) override;
  void scan_live(CsvReader& row) override;
  void read(CsvReader& row, Observation& out) const override;

 private:
  struct Curve {
    std::size_t index = 0;
    ArkitCurve meaning;
  };

  [[nodiscard]] double rate_by_frames() const;
  [[nodiscard]] double frames_per_second() const { return live_rate_.value_or(rate_by_frames()); }
  [[nodiscard]] std::optional<double> seconds(CsvReader& row) const;
  void read_eyes(CsvReader& row, Observation& out) const;
  static void add_larger(Observation& out, const ArkitCurve& meaning, double value);

  std::vector<Curve> curves_;
  std::optional<std::size_t> timecode_, count_, frame_;
  Times times_;
  std::array<std::optional<std::size_t>, 3> head_;
  std::array<std::optional<std::size_t>, 4> eyes_;  ///< yaw and pitch of the left, of the right eye
  bool head_turns_ = false;                         ///< some row has a head angle that is not 0
  bool eyes_turn_ = false;
  double frames_max_ = 0;
  double first_second_ = -1;
  std::optional<double> live_rate_;  ///< nullopt: the table is not live
  double live_second_ = -1;
  int live_seconds_ = 0;  ///< how many have begun
};

bool is_gaze(std::uint8_t number) {
  return number >= kEyesLeft && number <= kEyesDown;
}

Arkit::Arkit(const CsvReader& table, const ArkitTable& curves)
    : timecode_(table.column("Timecode")),
      count_(table.column("BlendShapeCount")),
      frame_(first_column(table, {"frame", "Frame", "frame_idx", "frame_id", "frame_number"})),
      times_(table),
      head_{curve_column(table, "headYaw"), curve_column(table, "headPitch"),
            curve_column(table, "headRoll")},
      eyes_{curve_column(table, "leftEyeYaw"), curve_column(table, "leftEyePitch"),
            curve_column(table, "rightEyeYaw"), curve_column(table, "rightEyePitch")} {
  for (const ArkitCurve& curve : curves.curves) {
    if (const auto index = curve_column(table, curve.curve)) curves_.push_back({*index, curve});
  }
}

void Arkit::scan(CsvReader& row) {
  times_.scan(row);
  const std::string_view text = row.text(timecode_);
  if (const auto timecode = parse_timecode(text)) {
    frames_max_ = std::max(frames_max_, std::floor(timecode->frames));
    if (first_second_ < 0) first_second_ = timecode->whole_seconds;
  } else if (timecode_ && !text.empty()) {
    row.refuse(timecode_, "expected a timecode HH:MM:SS:FF.fff, such as 16:55:51:38.453");
  }
  for (const auto& column : head_) head_turns_ |= row.number(column).value_or(0) != 0;
  for (const auto& column : eyes_) eyes_turn_ |= row.number(column).value_or(0) != 0;
}

/// The rate is 60 until a whole second has been counted, and is settled then: a rate that rose with
/// the frame numbers would set the time back again and again. Later it changes only if a frame
/// number shows that it is too low.
void Arkit::scan_live(CsvReader& row) {
  // The first may have begun before the table; the second is whole when the third begins.
  constexpr int kCounted = 3;
  scan(row);
  const auto timecode = parse_timecode(row.text(timecode_));
  if (!timecode) return;
  if (!live_rate_) live_rate_ = kUsualRate;
  if (timecode->whole_seconds != live_second_) {
    live_second_ = timecode->whole_seconds;
    if (++live_seconds_ == kCounted) live_rate_ = rate_by_frames();
  }
  if (frames_max_ >= *live_rate_) live_rate_ = rate_by_frames();
}

/// The least usual rate above every frame number seen. A take that never counts to 24 is too short
/// to tell.
double Arkit::rate_by_frames() const {
  if (frames_max_ < 24) return kUsualRate;
  for (const double rate : {25.0, 30.0, 48.0, 50.0, 60.0, 120.0, 240.0}) {
    if (frames_max_ < rate) return rate;
  }
  return frames_max_ + 1;
}

std::optional<double> Arkit::seconds(CsvReader& row) const {
  const auto timecode = parse_timecode(row.text(timecode_));
  if (!timecode) return times_.read(row);
  const double seconds = timecode->whole_seconds + timecode->frames / frames_per_second();
  // A take that runs over midnight goes on.
  const bool next_day = timecode->whole_seconds < first_second_ - kSecondsPerDay / 2;
  return next_day ? seconds + kSecondsPerDay : seconds;
}

void Arkit::read(CsvReader& row, Observation& out) const {
  out.seconds = seconds(row);
  out.frame = row.number(frame_);
  out.tracked = row.number(count_).value_or(1) > 0;
  for (const Curve& curve : curves_) {
    if (eyes_turn_ && is_gaze(curve.meaning.number)) continue;
    if (const auto value = row.number(curve.index)) add_larger(out, curve.meaning, *value);
  }
  if (head_turns_) {
    const auto yaw = row.number(head_[0]);
    const auto pitch = row.number(head_[1]);
    if (yaw && pitch) out.add_head({-*yaw, -*pitch, -row.number(head_[2]).value_or(0)});
  }
  if (eyes_turn_) read_eyes(row, out);
}

void Arkit::read_eyes(CsvReader& row, Observation& out) const {
  double yaw = 0;
  double pitch = 0;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const auto eye_yaw = row.number(eyes_[eye * 2]);
    const auto eye_pitch = row.number(eyes_[eye * 2 + 1]);
    if (!eye_yaw || !eye_pitch) return;
    yaw += *eye_yaw / 2;
    pitch += *eye_pitch / 2;
  }
  out.add_gaze({-yaw, -pitch, 0});
}

/// Curves that mean the same AU do not add up: the larger counts.
void Arkit::add_larger(Observation& out, const ArkitCurve& meaning, double value) {
  const double intensity = value * meaning.gain;
  const auto there = std::find_if(out.aus.begin(), out.aus.end(), [&](const AuValue& au) {
    return au.number == meaning.number && au.side == meaning.side;
  });
  if (there == out.aus.end()) {
    out.aus.push_back({meaning.number, meaning.side, intensity, true});
  } else {
    there->value = std::max(there->value, intensity);
  }
}

}  // namespace

bool has_arkit_curves(const CsvReader& table) {
  return curve_column(table, "jawOpen") && curve_column(table, "eyeBlinkLeft");
}

std::unique_ptr<Format> open_arkit(const CsvReader& table, const ArkitTable& curves) {
  if (!has_arkit_curves(table)) return nullptr;
  return std::make_unique<Arkit>(table, curves);
}

}  // namespace aucast::sources
