#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "common/sources/arkit_table.h"
#include "common/sources/csv_reader.h"
#include "common/sources/observation.h"

namespace aucast::sources {

/// Reads the tables of one kind of recogniser. A Format looks its columns up by name when it is
/// made.
class Format {
 public:
  Format() = default;
  Format(const Format&) = delete;
  Format& operator=(const Format&) = delete;
  virtual ~Format() = default;

  /// For reports: "OpenFace 2".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// The largest AU value of the format: 1, 5, 100, or 0 when only the values show it.
  [[nodiscard]] virtual double native_scale() const = 0;
  /// What the format decided or assumed, for reports; empty when there was nothing to decide. It
  /// may change as rows are read.
  [[nodiscard]] virtual std::string note() const { return {}; }
  /// Called with every row before any is read, to find out what single rows do not show.
  virtual void scan(CsvReader& /*row*/) {}
  /// The same for a live table, of which later rows are not known yet: called with each row just
  /// before it is read.
  virtual void scan_live(CsvReader& row) { scan(row); }
  /// Reads the present row into `out`, which the caller has cleared.
  virtual void read(CsvReader& row, Observation& out) const = 0;
};

/// The format that has these columns; null when none has. `load_curves` is called only for tables
/// of ARKit's curves; if it fails, so does open_format().
[[nodiscard]] Result<std::unique_ptr<Format>> open_format(const CsvReader& table,
                                                          const LoadCurves& load_curves);

/// Whether open_format() knows the columns.
[[nodiscard]] bool is_known(const CsvReader& table);

// === One function per family of recognisers. Each returns the family's format, or null when the
// columns are not the family's.

/// The tables that our own readers of cameras and films write.
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
