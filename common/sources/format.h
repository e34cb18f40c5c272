#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "common/sources/arkit_table.h"
#include "common/sources/csv_reader.h"
#include "common/sources/observation.h"

namespace aucast::sources {

/// How one kind of recogniser writes its tables. It looks its columns up by name when it is made.
class Format {
 public:
  Format() = default;
  Format(const Format&) = delete;
  Format& operator=(const Format&) = delete;
  virtual ~Format() = default;

  /// For reports: "OpenFace 2".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// The largest AU value of the format: 1, 5, 100, or 0 when only the values can tell.
  [[nodiscard]] virtual double native_scale() const = 0;
  /// What the reader decided or assumed, for reports; empty when there was nothing to decide. It
  /// may change with the rows seen.
  [[nodiscard]] virtual std::string note() const { return {}; }
  /// Looks at every row once before any is read, for what single rows cannot tell.
  virtual void scan(CsvReader& /*row*/) {}
  /// Reads the present row into `out`, which is empty.
  virtual void read(CsvReader& row, Observation& out) const = 0;
};

/// The format whose columns these are, or null. `load_curves` is called for tables of ARKit's
/// curves alone; its error is the result then.
[[nodiscard]] Result<std::unique_ptr<Format>> open_format(const CsvReader& table,
                                                          const LoadCurves& load_curves);

/// Whether open_format() knows the columns.
[[nodiscard]] bool is_known(const CsvReader& table);

// === One per family: the format, or null when the columns are not its own.

/// What our own camera and film readers write.
[[nodiscard]] std::unique_ptr<Format> open_camera_table(const CsvReader& table);
/// OpenFace 1 and 2, and FACSvatar's cleaned form of them.
[[nodiscard]] std::unique_ptr<Format> open_openface(const CsvReader& table);
/// Py-Feat, both detectors.
[[nodiscard]] std::unique_ptr<Format> open_pyfeat(const CsvReader& table);
/// LibreFace, FaceReader, iMotions.
[[nodiscard]] std::unique_ptr<Format> open_plain(const CsvReader& table);
/// Live Link Face, and ARKit's or MediaPipe's curves as people publish them.
[[nodiscard]] bool has_arkit_curves(const CsvReader& table);
[[nodiscard]] std::unique_ptr<Format> open_arkit(const CsvReader& table, const ArkitTable& curves);

}  // namespace aucast::sources
