#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "common/action_unit.h"
#include "common/sources/observation.h"

/// From the rows of a table to samples of a face: what recordings and live sources share.
namespace aucast::sources {

/// The scale that the format has, unless the values say otherwise. `native`: as the format says, 0
/// when only values can tell; `largest` of them.
[[nodiscard]] double scale_for(double native, double largest);

/// Whether the row has any data of a face.
[[nodiscard]] bool is_sure(const Observation& row, double confidence_min);

/// The row's intensities; -1 where it has no data, and everywhere if it is not sure. Those of turns
/// may be above 1, and that of the distance is how far the head is from the camera: a Conditioning
/// turns both into what can be shown.
[[nodiscard]] AuFrame update_of(const Observation& row, double scale, bool sure);

/// Which face a row is of. A format that does not name faces writes one row for each, with the same
/// picture number; they are counted within the picture.
class FaceNames {
 public:
  std::int64_t of(const Observation& row);

 private:
  std::optional<double> frame_;
  std::int64_t ordinal_ = 0;
};

/// Where a face is on a SourceClock.
struct FaceTimes {
  std::optional<double> last;
  double rows = 0;
  std::optional<double> refused;  ///< the last row's time, if it was not later than `last`
  std::size_t refusals = 0;       ///< of a run whose times ascend
};

/// Times from the first row on, by the source's own clock or by the pictures' numbers. Faces of
/// one source share it, so that what they did together stays together.
class SourceClock {
 public:
  /// `refusals_max`: after so many rows of a face that are not later than its last, but ascend
  /// among themselves, the clock must have been set back, or one time was wrong: time goes on from
  /// there. 0: never.
  explicit SourceClock(std::optional<double> fps, std::size_t refusals_max = 0)
      : fps_(fps), refusals_max_(refusals_max) {}

  /// Another recording was appended: if its clock starts again, it follows one step later.
  void restart() { restarted_ = true; }

  /// nullopt when the row has no time, or one that is not later than the last of its face.
  std::optional<double> time_of(const Observation& row, FaceTimes& face);
  /// The same for a source of which only one face is read.
  std::optional<double> time_of(const Observation& row) { return time_of(row, only_); }
  /// Whether the last sample was the first after the clock was set back.
  [[nodiscard]] bool was_set() const { return was_set_; }

 private:
  [[nodiscard]] bool was_set_back(double seconds, FaceTimes& face) const;

  std::optional<double> fps_;
  std::size_t refusals_max_;
  std::optional<double> begin_;
  std::optional<double> latest_;  ///< of all faces
  FaceTimes only_;
  double shift_ = 0;
  double step_ = 0.04;
  bool restarted_ = false;
  bool was_set_ = false;
};

}  // namespace aucast::sources
