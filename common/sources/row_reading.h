#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "common/action_unit.h"
#include "common/sources/observation.h"

/// What recordings and live sources share: turns the rows of a table into samples of a face.
namespace aucast::sources {

/// Latest time that a source's clock may show.
inline constexpr double kClockSecondsMax = 1e10;

/// Whether the value fits no scale: it is above 100, by more than rounding adds. It counts as no
/// data.
[[nodiscard]] bool fits_no_scale(const AuValue& au);

/// The value that is full intensity in the file. `native` is Format::native_scale(), 0 when only
/// the values can tell; `largest`, the largest value so far, can prove `native` wrong.
[[nodiscard]] double scale_for(double native, double largest);

/// Whether the row has data: the face was tracked, with enough confidence, and there are AUs.
[[nodiscard]] bool is_sure(const Observation& row, double confidence_min);

/// The row's intensities; -1 where the row has no data, and everywhere if `sure` is false. The
/// intensities of turns may be above 1, and that of AU 58 is the head's distance from the camera,
/// in units of the mesh. A Conditioning turns both into what can be shown.
[[nodiscard]] AuFrame update_of(const Observation& row, double scale, bool sure);

/// Tells which face a row is about. A format that does not name faces writes one row for each face
/// of a picture, all with the picture's number. These faces are numbered from 0 in each picture.
class FaceNames {
 public:
  std::int64_t of(const Observation& row);

 private:
  std::optional<double> frame_;
  std::int64_t ordinal_ = 0;
};

/// The times of one face on a SourceClock.
struct FaceTimes {
  std::optional<double> last_seconds;
  double rows = 0;
  std::optional<double> refused_seconds;  ///< of the last row, if it was refused
  std::size_t refusals = 0;               ///< successive refused rows, with ascending times
};

/// Gives each row its time in seconds since the first row, by the source's own clock or by the
/// number of the picture. All faces of a source share one clock, so that they stay synchronous.
class SourceClock {
 public:
  /// `refusals_max`: if this many successive rows of a face ascend among themselves, but are not
  /// later than its last accepted row, then the clock was set back or one time was wrong; time then
  /// goes on from there. 0: never.
  explicit SourceClock(std::optional<double> fps, std::size_t refusals_max = 0)
      : fps_(fps), refusals_max_(refusals_max) {}

  /// Call this when another recording follows. If the clock starts again with it, that recording
  /// begins one step after the last row.
  void restart() { restarted_ = true; }

  /// Returns the row's time; nullopt when the row has none, or when the time is not later than the
  /// face's last one.
  std::optional<double> seconds_of(const Observation& row, FaceTimes& face);
  /// The same for a source of which only one face is read.
  std::optional<double> seconds_of(const Observation& row) { return seconds_of(row, only_); }
  /// Whether the last row was the first after the clock was set back.
  [[nodiscard]] bool was_set() const { return was_set_; }

 private:
  [[nodiscard]] bool was_set_back(double seconds, FaceTimes& face) const;

  std::optional<double> fps_;
  std::size_t refusals_max_;
  std::optional<double> begin_seconds_;
  std::optional<double> latest_seconds_;  ///< of all faces
  FaceTimes only_;
  double shift_seconds_ = 0;
  double step_seconds_ = 0.04;
  bool restarted_ = false;
  bool was_set_ = false;
};

}  // namespace aucast::sources
