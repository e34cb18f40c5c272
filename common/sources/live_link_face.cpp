#include "common/sources/live_link_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace aucast::sources {
namespace {

constexpr double kSecondsPerDay = 86'400;

/// HH:MM:SS:FF.fff taken apart.
struct Timecode {
  double whole_seconds = 0;
  double frames = 0;
};

std::optional<Timecode> parse_timecode(std::string_view text) {
  std::array<double, 4> parts{};
  for (std::size_t index = 0; index < parts.size(); ++index) {
    const std::size_t colon = text.find(':');
    const bool last = index + 1 == parts.size();
    if (last != (colon == std::string_view::npos)) return std::nullopt;
    const auto value = parse_number(text.substr(0, colon), false);
    if (!value || *value < 0 || *value >= 1000) return std::nullopt;
    parts[index] = *value;
    if (!last) text.remove_prefix(colon + 1);
  }
  if (parts[0] >= 24 || parts[1] >= 60 || parts[2] >= 61) return std::nullopt;
  return Timecode{parts[0] * 3600 + parts[1] * 60 + parts[2], parts[3]};
}

/// Pairs of eye angle columns: yaw and pitch of the left, then of the right eye.
using EyeColumns = std::array<std::optional<std::size_t>, 4>;

/// Live Link Face for iPhone. Curves are bound by name: JawRight and MouthRight come before Left in
/// the file, after it in Unreal's own order. Eye angles are radians, positive to the subject's
/// right and down (checked against EyeLookIn, Out, Up and Down). The head's are taken to have the
/// same signs; they are all 0 unless the app was told to stream them. The frames of a timecode
/// count at a rate of their own, 60 a second even in a take of 30 pictures a second.
class LiveLinkFace final : public Format {
 public:
  LiveLinkFace(const CsvReader& table, const ArkitTable& curves);

  [[nodiscard]] std::string_view name() const override { return "Live Link Face"; }
  [[nodiscard]] double native_scale() const override { return 1; }
  [[nodiscard]] bool approximate() const override { return true; }
  void scan(CsvReader& row) override;
  void read(CsvReader& row, Observation& out) const override;

 private:
  struct Curve {
    std::size_t index = 0;
    ArkitCurve meaning;
  };

  [[nodiscard]] double frames_per_second() const;
  void read_eyes(CsvReader& row, Observation& out) const;
  static void add_larger(Observation& out, const ArkitCurve& meaning, double value);

  std::vector<Curve> curves_;
  std::optional<std::size_t> timecode_, count_;
  std::array<std::optional<std::size_t>, 3> head_;
  EyeColumns eyes_;
  bool head_turns_ = false;  ///< some row has a head angle that is not 0
  bool eyes_turn_ = false;
  double frames_max_ = 0;
  double first_second_ = -1;
};

bool is_gaze(std::uint8_t number) {
  return number >= 61 && number <= 64;
}

std::string pascal_case(std::string name) {
  if (!name.empty() && name.front() >= 'a' && name.front() <= 'z') {
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
  }
  return name;
}

LiveLinkFace::LiveLinkFace(const CsvReader& table, const ArkitTable& curves)
    : timecode_(table.column("Timecode")),
      count_(table.column("BlendShapeCount")),
      head_{table.column("HeadYaw"), table.column("HeadPitch"), table.column("HeadRoll")},
      eyes_{table.column("LeftEyeYaw"), table.column("LeftEyePitch"), table.column("RightEyeYaw"),
            table.column("RightEyePitch")} {
  for (const ArkitCurve& curve : curves.curves) {
    if (const auto index = table.column(pascal_case(curve.curve))) {
      curves_.push_back({*index, curve});
    }
  }
}

void LiveLinkFace::scan(CsvReader& row) {
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

/// The least usual rate above every frame number seen. A take that never counts to 24 is too short
/// to tell; the app's own is 60.
double LiveLinkFace::frames_per_second() const {
  if (frames_max_ < 24) return 60;
  for (const double rate : {25.0, 30.0, 48.0, 50.0, 60.0, 120.0, 240.0}) {
    if (frames_max_ < rate) return rate;
  }
  return frames_max_ + 1;
}

void LiveLinkFace::read(CsvReader& row, Observation& out) const {
  if (const auto timecode = parse_timecode(row.text(timecode_))) {
    double seconds = timecode->whole_seconds + timecode->frames / frames_per_second();
    // A take that runs over midnight goes on.
    if (timecode->whole_seconds < first_second_ - kSecondsPerDay / 2) seconds += kSecondsPerDay;
    out.seconds = seconds;
  }
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

void LiveLinkFace::read_eyes(CsvReader& row, Observation& out) const {
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
void LiveLinkFace::add_larger(Observation& out, const ArkitCurve& meaning, double value) {
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

bool is_live_link_face(const CsvReader& table) {
  return table.column("JawOpen") && table.column("EyeBlinkLeft") &&
         (table.column("Timecode") || table.column("BlendShapeCount"));
}

std::unique_ptr<Format> open_live_link_face(const CsvReader& table, const ArkitTable& curves) {
  if (!is_live_link_face(table)) return nullptr;
  return std::make_unique<LiveLinkFace>(table, curves);
}

}  // namespace aucast::sources
