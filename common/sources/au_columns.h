#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "common/sources/csv_reader.h"
#include "common/sources/observation.h"

namespace aucast::sources {

/// The columns of a table that are AUs.
class AuColumns {
 public:
  AuColumns() = default;
  /// Those whose names are an AU number after a prefix and before a suffix: AU01_r,
  /// au_1_intensity. With kAnySuffix anything may stand before and after, a word Left or Right is
  /// the side, and a cell may be a FACS letter.
  static constexpr std::string_view kAnySuffix = "*";
  AuColumns(const CsvReader& table, std::string_view prefix, std::string_view suffix);

  [[nodiscard]] bool empty() const { return columns_.empty(); }
  [[nodiscard]] std::size_t size() const { return columns_.size(); }
  /// Adds a column that means an AU.
  void add(std::uint8_t number, Side side, std::size_t index);
  /// Leaves out what `other` has: presence is of use only where there is no intensity.
  void remove(const AuColumns& other);

  /// Intensities of the row on the source's own scale.
  void read(CsvReader& row, Observation& out) const;
  /// Presences of the row, 0 or 1; above 0.5 is kPresentIntensity.
  void read_presence(CsvReader& row, Observation& out) const;
  /// Evidence e of the row, the decimal logarithm of the odds that the AU is there. The intensity
  /// is 0 at even odds and 1 at certainty.
  void read_evidence(CsvReader& row, Observation& out) const;

 private:
  struct Column {
    std::uint8_t number = 0;
    Side side = Side::Both;
    std::size_t index = 0;
  };
  [[nodiscard]] bool has(std::uint8_t number, Side side) const;
  bool letters_ = false;
  std::vector<Column> columns_;  ///< those without a side first, so that a side wins
};

}  // namespace aucast::sources
