#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "client/net/remote_source.h"

namespace aucast::net::test {

/// Long enough for any machine; no test waits for it when all is well.
inline constexpr auto kPatience = std::chrono::seconds(20);

/// Starts to play when the second keyframe comes; has room for whatever a test sends.
inline constexpr playback::BufferOptions kEager{100, 100, 1};

[[nodiscard]] inline Instant patience() {
  return std::chrono::steady_clock::now() + kPatience;
}

[[nodiscard]] inline RemoteOptions options_for(std::uint16_t port, bool classic = false) {
  RemoteOptions options;
  options.host = "127.0.0.1";
  options.port = port;
  options.classic = classic;
  options.connect_timeout = kPatience;
  options.buffers = kEager;
  return options;
}

/// Waits for the next keyframe and returns its first AU; 0 at the end.
[[nodiscard]] inline int take_au(RemoteSource& source) {
  while (source.wait_until(patience())) {
    const auto keyframe = source.take();
    if (!keyframe) return 0;
    for (int au = 1; au < kAuCount; ++au) {
      if (keyframe->aus.left[static_cast<std::size_t>(au)] > 0) return au;
    }
  }
  return 0;
}

/// The first AUs of all keyframes up to the end.
[[nodiscard]] inline std::vector<int> take_all(RemoteSource& source) {
  std::vector<int> all;
  while (const int au = take_au(source)) all.push_back(au);
  return all;
}

}  // namespace aucast::net::test
