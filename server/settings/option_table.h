#pragma once

#include <string>
#include <vector>

#include "common/manual.h"
#include "common/options.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// All options of au-transmitter in the order of --help, bound to `options`.
[[nodiscard]] std::vector<OptionRow> option_rows(TransmitterOptions& options);

/// What --help and the manual page say of serving.
[[nodiscard]] CommandPage transmitter_page();

}  // namespace aucast::server
