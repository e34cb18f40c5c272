#pragma once

#include <bitset>
#include <string>

#include "client/pipeline/au_mapping.h"
#include "common/action_unit.h"

namespace aucast::app {

/// Reports each AU that was asked for and that the face cannot show, once in a run.
class MissingAus {
 public:
  /// Returns a warning about those of these AUs that have not been reported yet, with their FACS
  /// names; empty if there are none.
  [[nodiscard]] std::string look_at(const pipeline::AuMapping& mapping, const AuFrame& aus);

 private:
  std::bitset<kAuCount> said_;
};

/// The warning that a face cannot show some of these AUs; empty if it shows all.
[[nodiscard]] std::string missing_text(const face::Face& face, const AuFrame& aus);

}  // namespace aucast::app
