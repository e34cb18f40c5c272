#pragma once

#include <vector>

#include "common/result.h"
#include "server/settings/signal_options.h"
#include "server/streams/load_sources.h"

namespace aucast::server {

/// Writes the profile of --save-profile: that of the `conditioning` with which the sources were
/// read, and with the neutral face that was measured in the source, if that was asked for. For a
/// live source it is measured later, and nothing is written yet. Fails with a Usage error if it is
/// to be measured but there is not exactly one source to measure; other errors are those of
/// save_profile().
[[nodiscard]] Result<void> save_measured_profile(const SignalOptions& options,
                                                 const sources::ConditioningSettings& conditioning,
                                                 const std::vector<Source>& sources);

}  // namespace aucast::server
