#pragma once

#include "common/result.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// Checks, by the kinds of the files, that the sources can be served with --preview, --voice and
/// --record, if these are given. Fails with a Usage error if not.
[[nodiscard]] Result<void> check_sources(const TransmitterOptions& options);

}  // namespace aucast::server
