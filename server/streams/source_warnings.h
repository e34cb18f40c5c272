#pragma once

#include <string>
#include <vector>

#include "server/streams/load_sources.h"

namespace aucast::server {

/// What a user should know of sources that were read without an error: titles that no client gets,
/// and options that change nothing in any of the sources. One sentence each.
[[nodiscard]] std::vector<std::string> source_warnings(const std::vector<Source>& sources,
                                                       const SourceOptions& options);

}  // namespace aucast::server
