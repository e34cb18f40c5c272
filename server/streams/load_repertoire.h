#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "common/result.h"
#include "common/sources/conditioning.h"
#include "server/settings/transmitter_options.h"
#include "server/streams/load_sources.h"
#include "server/streams/repertoire.h"

namespace aucast::server {

/// Reads and encodes the sources of the options: for serving or, with all details, for --check and
/// --estimate. Logs what --skip-bad leaves out. Errors are those of load_sources().
[[nodiscard]] Result<std::vector<Source>> load_asked(
    const TransmitterOptions& options, const sources::ConditioningSettings& conditioning,
    const std::stop_token& stop = {});

/// What is served, and how the signals of recognisers are conditioned: in the recordings, and in
/// what live sources deliver from now on.
struct LoadedSources {
  Repertoire repertoire;
  sources::ConditioningSettings conditioning;
};

/// Loads what is served with these options; reads the profile of --profile once. Writes that of
/// --save-profile, and logs what was found in recordings, since a wrong scale looks like a weak
/// face. Errors are those of load_asked(), check_live_loop() and save_measured_profile().
[[nodiscard]] Result<LoadedSources> load_repertoire(const TransmitterOptions& options,
                                                    const std::stop_token& stop = {});

/// How many of the sources that have a name, counted from the first, fit into the list of streams,
/// which is one packet.
[[nodiscard]] std::size_t listed(const std::vector<Source>& sources);

}  // namespace aucast::server
