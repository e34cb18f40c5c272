#pragma once

#include <memory>

#include "common/sources/arkit_table.h"
#include "common/sources/format.h"

namespace aucast::sources {

/// True when the columns are those of Live Link Face: ARKit's curves in PascalCase.
[[nodiscard]] bool is_live_link_face(const CsvReader& table);

/// The format, reading curves by `curves`; nothing when the columns are not its own.
[[nodiscard]] std::unique_ptr<Format> open_live_link_face(const CsvReader& table,
                                                          const ArkitTable& curves);

}  // namespace aucast::sources
