#pragma once

#include <string>

namespace aucast::server {

/// au-transmitter(1) in roff, from the table of options.
[[nodiscard]] std::string manual_page();

/// What makes bash complete au-transmitter's options.
[[nodiscard]] std::string completion();

}  // namespace aucast::server
