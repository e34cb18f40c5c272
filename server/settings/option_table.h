#pragma once

#include <string>
#include <vector>

#include "common/manual.h"
#include "common/options.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// All options of au-transmitter in the order of --help, bound to `options`.
[[nodiscard]] std::vector<OptionRow> option_rows(TransmitterOptions& options);

/// The texts of --help and the manual page about serving.
[[nodiscard]] CommandPage transmitter_page();

}  // namespace aucast::server
