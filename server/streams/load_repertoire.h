#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "common/result.h"
#include "server/settings/transmitter_options.h"
#include "server/streams/load_sources.h"
#include "server/streams/repertoire.h"

namespace aucast::server {

/// The sources of the options, read and encoded as these ask: for serving, or whole for --check and
/// --estimate. The log names what --skip-bad leaves out. Errors of load_sources().
[[nodiscard]] Result<std::vector<Source>> load_asked(const TransmitterOptions& options,
                                                     const std::stop_token& stop = {});

/// What is served with these options, as it is now. Writes the profile of --save-profile, and logs
/// what was found in recordings: a wrong scale looks like a weak face. Errors of load_asked(),
/// check_live() and save_measured_profile().
[[nodiscard]] Result<Repertoire> load_repertoire(const TransmitterOptions& options,
                                                 const std::stop_token& stop = {});

/// How many of the sources that have a name, from the first on, the list of streams has room for:
/// it is one packet.
[[nodiscard]] std::size_t listed(const std::vector<Source>& sources);

}  // namespace aucast::server
