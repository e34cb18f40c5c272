#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "common/sources/csv_reader.h"
#include "common/sources/observation.h"

namespace aucast::sources {

/// Those columns of a table that are AUs.
class AuColumns {
 public:
  AuColumns() = default;
  /// Finds the columns whose names are an AU number between a prefix and a suffix: AU01_r,
  /// au_1_intensity. With kAnySuffix other words may come before and after, the word Left or Right
  /// is the side, and a cell may be a FACS letter.
  static constexpr std::string_view kAnySuffix = "*";
  AuColumns(const CsvReader& table, std::string_view prefix, std::string_view suffix);

  [[nodiscard]] bool empty() const { return columns_.empty(); }
  [[nodiscard]] std::size_t size() const { return columns_.size(); }
  /// Adds column `index`, which is AU `number` on `side`.
  void add(std::uint8_t number, Side side, std::size_t index);
  /// Removes the AUs that `other` has too, so that the presence of an AU is used only where the
  /// table has no intensity of it.
  void remove(const AuColumns& other);

  /// Reads the row's intensities, on the source's own scale.
  void read(CsvReader& row, Observation& out) const;
  /// Reads presences, 0 or 1: above 0.5 becomes kPresentIntensity, anything else 0.
  void read_presence(CsvReader& row, Observation& out) const;
  /// Reads evidence, the decimal logarithm of the odds that the AU is there, as intensities: 0 at
  /// even odds or less, 1 at certainty.
  void read_evidence(CsvReader& row, Observation& out) const;

 private:
  struct Column {
    std::uint8_t number = 0;
    Side side = Side::Both;
    std::size_t index = 0;
  };
  [[nodiscard]] bool has(std::uint8_t number, Side side) const;
  bool letters_ = false;
  std::vector<Column> columns_;  ///< those without a side first, so that one with a side wins
};

}  // namespace aucast::sources
