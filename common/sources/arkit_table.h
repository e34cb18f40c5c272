#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::sources {

/// A blend-shape curve read as an AU: intensity = curve x gain.
struct ArkitCurve {
  std::string curve;  ///< "jawOpen"
  std::uint8_t number = 0;
  Side side = Side::Both;
  double gain = 1;
};

/// How ARKit's curves are read as AUs: an approximation, so it is data (common/sources/FORMATS.md).
struct ArkitTable {
  std::vector<ArkitCurve> curves;
};

/// Loads the table; called only when it is needed.
using LoadCurves = std::function<Result<ArkitTable>()>;

/// Loads the table of the data folder.
[[nodiscard]] Result<ArkitTable> load_arkit_table();

/// Reads a table with the columns curve, au, side (L, R or B) and gain. Fails with BadData and
/// file:line:column if something in it is wrong.
[[nodiscard]] Result<ArkitTable> parse_arkit_table(std::string_view text, std::string_view file);

}  // namespace aucast::sources
