#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/action_unit.h"
#include "common/mesh/au_weights.h"

namespace aucast::camera {

/// What is seen of a face as a table of our own, which common/sources reads like any recogniser's:
/// `aucast_seconds`, `confidence`, `success`, and a column for each AU, L12 and R12 where sides are
/// told, in percent. Turns of head and eyes may be above 100.
class FaceTable {
 public:
  explicit FaceTable(const mesh::AuWeights& weights);

  /// The line with the names of the columns.
  [[nodiscard]] const std::string& header() const { return header_; }
  /// A line; without a face it has no success and empty cells.
  [[nodiscard]] std::string row(double seconds, double confidence,
                                const std::optional<AuFrame>& face) const;
  /// What a row says of a face in whole percent, a term for each column of an AU.
  [[nodiscard]] std::vector<AuTerm> terms(const AuFrame& face) const;

 private:
  struct Column {
    std::uint8_t number;
    Side side;
  };
  std::vector<Column> columns_;
  std::string header_ = "aucast_seconds,confidence,success";
};

}  // namespace aucast::camera
