#pragma once

#include <array>
#include <optional>

#include "common/sources/au_columns.h"

namespace aucast::sources {

/// Where the versions of Py-Feat differ.
struct PyFeatAngles {
  double rad_per_unit = 1;
  double roll_right = 1;  ///< 1: a positive roll is the subject's right, -1: the left
};

/// The columns that Py-Feat 1 and 2 share. A positive pitch is up and a positive yaw the subject's
/// right; gaze likewise. There are frame numbers but no times.
class PyFeatColumns {
 public:
  PyFeatColumns(const CsvReader& table, const PyFeatAngles& angles);

  [[nodiscard]] static bool fits(const CsvReader& table);
  void read(CsvReader& row, Observation& out) const;

 private:
  PyFeatAngles angles_;
  AuColumns intensities_;
  std::optional<std::size_t> frame_, score_;
  std::array<std::optional<std::size_t>, 3> pose_;
  std::array<std::optional<std::size_t>, 2> gaze_;
};

/// True for the second detector, which alone has valence and a mesh.
[[nodiscard]] bool is_pyfeat2(const CsvReader& table);

}  // namespace aucast::sources
