#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/action_unit.h"
#include "common/mesh/au_weights.h"

namespace aucast::camera {

/// What is seen of a face as a table of our own, which common/sources reads like any recogniser's:
/// `aucast_seconds`, `confidence`, `success`, `face_id` of several faces, and a column for each AU,
/// L12 and R12 where sides are told, in percent. Turns of head and eyes may be above 100.
class FaceTable {
 public:
  /// `several`: rows name their face.
  explicit FaceTable(const mesh::AuWeights& weights, bool several = false);

  /// The line with the names of the columns.
  [[nodiscard]] const std::string& header() const { return header_; }
  /// A line; without a face it has no success and empty cells.
  [[nodiscard]] std::string row(double seconds, double confidence,
                                const std::optional<AuFrame>& face, std::size_t number = 0) const;
  /// What a row says of a face in whole percent, a term for each column of an AU.
  [[nodiscard]] std::vector<AuTerm> terms(const AuFrame& face) const;

 private:
  struct Column {
    std::uint8_t number;
    Side side;
  };
  std::vector<Column> columns_;
  bool several_;
  std::string header_ = "aucast_seconds,confidence,success";
};

}  // namespace aucast::camera
