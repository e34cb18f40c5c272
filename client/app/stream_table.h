#pragma once

#include <string>

#include "protocol/packet.h"

namespace aucast::app {

/// The names of a server's streams, one a line: what --list prints for other programs.
[[nodiscard]] std::string stream_names(const protocol::StreamList& list);

/// The same for people: a line for each stream, with its name, whether it is live or how long it
/// is, and its title, in columns. What is not known is left out.
[[nodiscard]] std::string stream_table(const protocol::StreamList& list);

}  // namespace aucast::app
