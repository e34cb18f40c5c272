#include "common/sources/format.h"
#include "common/sources/pyfeat_columns.h"

namespace aucast::sources {
namespace {

/// Py-Feat with its first detector: pose in degrees, a positive roll the subject's left, no gaze.
class PyFeat1 final : public Format {
 public:
  explicit PyFeat1(const CsvReader& table) : columns_(table, {kRadPerDegree, -1}) {}

  [[nodiscard]] std::string_view name() const override { return "Py-Feat 1"; }
  [[nodiscard]] double native_scale() const override { return 1; }
  void read(CsvReader& row, Observation& out) const override { columns_.read(row, out); }

 private:
  PyFeatColumns columns_;
};

}  // namespace

std::unique_ptr<Format> open_pyfeat1(const CsvReader& table) {
  if (!PyFeatColumns::fits(table) || is_pyfeat2(table)) return nullptr;
  return std::make_unique<PyFeat1>(table);
}

}  // namespace aucast::sources
