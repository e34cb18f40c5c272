#include "common/sources/format.h"

namespace aucast::sources {
namespace {

/// Formats that need no curves. Py-Feat 2 has ARKit's curves beside its AUs.
std::unique_ptr<Format> open_aus(const CsvReader& table) {
  for (const auto open : {open_camera_table, open_openface, open_pyfeat, open_plain}) {
    if (auto format = open(table)) return format;
  }
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<Format>> open_format(const CsvReader& table, const LoadCurves& load_curves) {
  auto format = open_aus(table);
  if (format || !has_arkit_curves(table)) return format;
  const auto curves = load_curves();
  if (!curves) return curves.error();
  return open_arkit(table, *curves);
}

bool is_known(const CsvReader& table) {
  return has_arkit_curves(table) || open_aus(table) != nullptr;
}

}  // namespace aucast::sources
