#include "common/sources/format.h"
#include "common/sources/pyfeat_columns.h"

namespace aucast::sources {
namespace {

/// Py-Feat with its second detector: pose and gaze in radians, a positive roll the subject's
/// right.
class PyFeat2 final : public Format {
 public:
  explicit PyFeat2(const CsvReader& table) : columns_(table, {1, 1}) {}

  [[nodiscard]] std::string_view name() const override { return "Py-Feat 2"; }
  [[nodiscard]] double native_scale() const override { return 1; }
  void read(CsvReader& row, Observation& out) const override { columns_.read(row, out); }

 private:
  PyFeatColumns columns_;
};

}  // namespace

std::unique_ptr<Format> open_pyfeat2(const CsvReader& table) {
  if (!PyFeatColumns::fits(table) || !is_pyfeat2(table)) return nullptr;
  return std::make_unique<PyFeat2>(table);
}

}  // namespace aucast::sources
