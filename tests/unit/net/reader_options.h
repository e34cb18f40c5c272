#pragma once

#include "client/net/au_reader.h"

namespace aucast::test {

/// Of a reader of server:4650, its first stream.
inline net::AuReaderOptions reader_options(bool classic, const playback::BufferOptions& buffers) {
  net::AuReaderOptions options;
  options.classic = classic;
  options.buffers = buffers;
  options.peer = "server:4650";
  return options;
}

}  // namespace aucast::test
