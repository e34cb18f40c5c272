#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "common/sources/au_columns.h"
#include "common/sources/format.h"

namespace aucast::sources {
namespace {

/// Heads that turn further are in degrees.
constexpr double kRadiansMax = 1.6;

/// Whether two series rise together, from sums: their correlation.
class Correlation {
 public:
  void add(double x, double y) {
    ++count_;
    // Around the first pair, so that the sums keep their digits.
    if (count_ == 1) origin_ = {x, y};
    x -= origin_[0];
    y -= origin_[1];
    x_ += x;
    y_ += y;
    xx_ += x * x;
    yy_ += y * y;
    xy_ += x * y;
  }

  /// 0 of fewer than ten pairs, and when one of the two does not change.
  [[nodiscard]] double value() const {
    const double spread = (count_ * xx_ - x_ * x_) * (count_ * yy_ - y_ * y_);
    if (count_ < 10 || spread <= 0) return 0;
    return (count_ * xy_ - x_ * y_) / std::sqrt(spread);
  }

 private:
  std::array<double, 2> origin_{};
  double count_ = 0, x_ = 0, y_ = 0, xx_ = 0, yy_ = 0, xy_ = 0;
};

/// How far down the bridge of the nose its tip is seen: the more, the further the head is down. The
/// face's size, place, roll and expression do not matter. The points are those of MediaPipe's mesh
/// between the eyes (168), at the tip (4) and where the nose ends (2), or of the 68 landmarks 27,
/// 30 and 33. The mesh comes first: version 2 takes its landmark 33 from the mesh's point 1, which
/// is so near the tip that a nod hardly shows.
class NoseColumns {
 public:
  explicit NoseColumns(const CsvReader& table) {
    if (!find(table, "mesh_", {"168", "4", "2"})) find(table, "", {"27", "30", "33"});
  }

  [[nodiscard]] std::optional<double> read(CsvReader& row) const {
    std::array<double, 6> at{};
    for (std::size_t index = 0; index < 3; ++index) {
      const auto x = row.number(x_[index]);
      const auto y = row.number(y_[index]);
      if (!x || !y) return std::nullopt;
      at[index] = *x;
      at[index + 3] = *y;
    }
    const double along_x = at[2] - at[0];
    const double along_y = at[5] - at[3];
    const double length = along_x * along_x + along_y * along_y;
    if (length <= 0) return std::nullopt;
    return ((at[1] - at[0]) * along_x + (at[4] - at[3]) * along_y) / length;
  }

 private:
  /// False when the table does not have all three points.
  bool find(const CsvReader& table, const std::string& prefix,
            const std::array<std::string, 3>& points) {
    bool all = true;
    for (std::size_t index = 0; index < points.size(); ++index) {
      x_[index] = table.column(prefix + "x_" + points[index]);
      y_[index] = table.column(prefix + "y_" + points[index]);
      all = all && x_[index] && y_[index];
    }
    return all;
  }

  std::array<std::optional<std::size_t>, 3> x_;
  std::array<std::optional<std::size_t>, 3> y_;
};

/// Py-Feat. Two detectors with the same columns, of which the second has valence, a mesh and curves
/// beside them. A positive yaw is the subject's right; gaze likewise, and positive up. Up to 0.6
/// the pose was in degrees, a positive roll the subject's left, and there was no gaze; from 0.7 on
/// it is in radians, a positive roll the subject's right. Which way a positive pitch goes changed
/// in 2026: the landmarks tell. There are picture numbers but no times.
class PyFeat final : public Format {
 public:
  explicit PyFeat(const CsvReader& table)
      : second_(table.column("valence") || table.column("mesh_x_0")),
        intensities_(table, "AU", ""),
        frame_(table.column("frame")),
        score_(table.column("FaceScore")),
        pose_{table.column("Pitch"), table.column("Yaw"), table.column("Roll")},
        gaze_{table.column("gaze_pitch"), table.column("gaze_yaw")},
        nose_(table),
        known_(score_ || table.column("FaceRectX")),
        may_be_degrees_(!second_ && !gaze_[0]),
        degrees_(may_be_degrees_ && !table.column("X")) {}

  [[nodiscard]] bool fits() const { return known_ && !intensities_.empty(); }
  [[nodiscard]] std::string_view name() const override {
    return second_ ? "Py-Feat 2" : "Py-Feat 1";
  }
  [[nodiscard]] double native_scale() const override { return 1; }

  [[nodiscard]] std::string note() const override {
    if (!pose_[0]) return {};
    return std::string("pose in ") + (degrees_ ? "degrees" : "radians") + ", positive pitch " +
           (pitch_down_.value_or(false) ? "down" : "up") +
           (pitch_down_ ? " as the landmarks say" : " as documented");
  }

  void scan(CsvReader& row) override {
    for (const auto& angle : pose_) {
      const double turned = std::abs(row.number(angle).value_or(0));
      degrees_ = degrees_ || (may_be_degrees_ && turned > kRadiansMax);
    }
    const auto pitch = row.number(pose_[0]);
    const auto nose = nose_.read(row);
    if (!pitch || !nose) return;
    constexpr double kClear = 0.4;
    pitch_to_nose_.add(*pitch, *nose);
    const double together = pitch_to_nose_.value();
    if (std::abs(together) >= kClear) pitch_down_ = together > 0;
  }

  void read(CsvReader& row, Observation& out) const override {
    out.frame = row.number(frame_);
    out.confidence = row.number(score_).value_or(1);
    intensities_.read(row, out);
    const auto pitch = row.number(pose_[0]);
    const auto yaw = row.number(pose_[1]);
    const auto roll = row.number(pose_[2]);
    if (pitch && yaw && roll) {
      const double unit = degrees_ ? kRadPerDegree : 1;
      const double up = pitch_down_.value_or(false) ? -1 : 1;
      const double roll_left = degrees_ ? 1 : -1;
      out.add_head({-*yaw * unit, *pitch * unit * up, *roll * unit * roll_left});
    }
    const auto gaze_pitch = row.number(gaze_[0]);
    const auto gaze_yaw = row.number(gaze_[1]);
    if (gaze_pitch && gaze_yaw) out.add_gaze({-*gaze_yaw, *gaze_pitch, 0});
  }

 private:
  bool second_;
  AuColumns intensities_;
  std::optional<std::size_t> frame_, score_;
  std::array<std::optional<std::size_t>, 3> pose_;
  std::array<std::optional<std::size_t>, 2> gaze_;
  NoseColumns nose_;
  bool known_;
  bool may_be_degrees_;
  bool degrees_;
  Correlation pitch_to_nose_;
  std::optional<bool> pitch_down_;  ///< nothing: the landmarks have not told
};

}  // namespace

std::unique_ptr<Format> open_pyfeat(const CsvReader& table) {
  auto format = std::make_unique<PyFeat>(table);
  if (!format->fits()) return nullptr;
  return format;
}

}  // namespace aucast::sources
