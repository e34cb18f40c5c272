#pragma once

#include "common/result.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// Checks that these sources can be served with --preview, --voice and --record, if these are
/// given. Usage error if not. Looks at the kinds of the files.
[[nodiscard]] Result<void> check_sources(const TransmitterOptions& options);

}  // namespace aucast::server
