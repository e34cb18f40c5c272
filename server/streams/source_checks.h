#pragma once

#include "common/result.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// Whether these sources can be served as is asked for: with --preview, --voice and --record. Usage
/// error if not. Looks at what kind of file a path is.
[[nodiscard]] Result<void> check_sources(const TransmitterOptions& options);

}  // namespace aucast::server
