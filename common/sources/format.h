#pragma once

#include <memory>
#include <string_view>

#include "common/sources/csv_reader.h"
#include "common/sources/observation.h"

namespace aucast::sources {

/// How one kind of recogniser writes its tables. One small file each; which columns there are was
/// looked up by name when it was made.
class Format {
 public:
  Format() = default;
  Format(const Format&) = delete;
  Format& operator=(const Format&) = delete;
  virtual ~Format() = default;

  /// For reports: "OpenFace 2".
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// What its own AU values reach: 5, 1, or 0 when only the values can tell.
  [[nodiscard]] virtual double native_scale() const = 0;
  /// True when its AUs are a reading of something else.
  [[nodiscard]] virtual bool approximate() const { return false; }
  /// Sees every row once before the first read(), for what only the whole file can tell.
  virtual void scan(CsvReader& /*row*/) {}
  /// Reads the present row into `out`, which is empty.
  virtual void read(CsvReader& row, Observation& out) const = 0;
};

// === One per file: the format, or nothing when the columns are not its own.

[[nodiscard]] std::unique_ptr<Format> open_openface2(const CsvReader& table);
[[nodiscard]] std::unique_ptr<Format> open_openface1(const CsvReader& table);
[[nodiscard]] std::unique_ptr<Format> open_facsvatar(const CsvReader& table);
[[nodiscard]] std::unique_ptr<Format> open_pyfeat1(const CsvReader& table);
[[nodiscard]] std::unique_ptr<Format> open_pyfeat2(const CsvReader& table);
[[nodiscard]] std::unique_ptr<Format> open_libreface(const CsvReader& table);

}  // namespace aucast::sources
