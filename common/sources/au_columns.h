#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "common/sources/csv_reader.h"
#include "common/sources/observation.h"

namespace aucast::sources {

/// The columns whose names are an AU number between a prefix and a suffix: AU01_r, au_1_intensity.
class AuColumns {
 public:
  AuColumns() = default;
  AuColumns(const CsvReader& table, std::string_view prefix, std::string_view suffix);

  [[nodiscard]] bool empty() const { return columns_.empty(); }
  [[nodiscard]] bool has(std::uint8_t number) const;
  /// Leaves out what `other` has: presence is of use only where there is no intensity.
  void remove(const AuColumns& other);
  /// Intensities of the row on the source's own scale.
  void read(CsvReader& row, Observation& out) const;
  /// Presences of the row, 0 or 1; above 0.5 is kPresentIntensity.
  void read_presence(CsvReader& row, Observation& out) const;

 private:
  struct Column {
    std::uint8_t number = 0;
    std::size_t index = 0;
  };
  std::vector<Column> columns_;
};

}  // namespace aucast::sources
