#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/action_unit.h"
#include "common/mesh/au_weights.h"

namespace aucast::camera {

/// Writes what is seen of faces as a table of our own, which common/sources reads like any
/// recogniser's. Its columns are `aucast_seconds`, `confidence`, `success`, `face_id` if there are
/// several faces, and each AU in percent: L12 and R12 where sides are told apart. Turns of head and
/// eyes may be above 100.
class FaceTable {
 public:
  /// `several`: whether rows have a `face_id`.
  explicit FaceTable(const mesh::AuWeights& weights, bool several = false);

  /// The line with the names of the columns.
  [[nodiscard]] const std::string& header() const { return header_; }
  /// The line of one face. If `face` is nullopt, `success` is 0 and the AUs are empty. `number`:
  /// the `face_id`.
  [[nodiscard]] std::string row(double seconds, double confidence,
                                const std::optional<AuFrame>& face, std::size_t number = 0) const;
  /// The AUs of row() in whole percent: one term for each column of an AU.
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
