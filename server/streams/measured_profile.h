#pragma once

#include <vector>

#include "common/result.h"
#include "server/settings/signal_options.h"
#include "server/streams/load_sources.h"

namespace aucast::server {

/// Writes the profile that is asked for with --save-profile, with the neutral face that was
/// measured in the sources if one is to be; of a live source that is measured later, and nothing is
/// written yet. Usage error when not exactly one source can be measured; errors of save_profile().
[[nodiscard]] Result<void> save_measured_profile(const SignalOptions& options,
                                                 const std::vector<Source>& sources);

}  // namespace aucast::server
