#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "common/result.h"

namespace aucast::test {

/// A place of the face: a ring and spoke of the skin, or, of a named part, the vertex nearest to
/// a point of the neutral face.
struct Landmark {
  std::string name;
  std::string patch;  ///< "eye" or "mouth"; empty: found by `part` and `near`
  int ring = 0;
  int spoke = 0;
  std::string part;
  glm::vec3 near{0};
};

enum class Way : std::uint8_t { Up, Forward, Out, Left };

/// How far a landmark goes at full intensity.
struct Expected {
  std::string at;
  Way way = Way::Up;
  float least_mm = 0;
  float most_mm = 0;
};

struct CalibratedAu {
  int number = 0;
  bool sided = false;
  std::vector<Expected> expect;
  std::vector<std::string> still;  ///< landmarks that hardly move
};

/// data/faces/calibration.toml, which describes itself.
struct Calibration {
  float mm_per_unit = 14;
  float still_mm = 1;
  std::vector<Landmark> landmarks;
  std::vector<CalibratedAu> aus;

  [[nodiscard]] const Landmark* find(const std::string& name) const;
};

/// Fails with BadData and file:line:column if something is missing, such as the closing table
/// [end], or unknown, such as the name of a landmark that the file does not define.
[[nodiscard]] Result<Calibration> load_calibration(const std::filesystem::path& file);

}  // namespace aucast::test
