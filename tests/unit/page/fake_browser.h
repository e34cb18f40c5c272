#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

/// A browser in the place of client/web's (browser.h): the test is the network, and lets timers
/// ring.
namespace aucast::test {

struct FakeBrowser {
  std::set<std::uint32_t> sockets;  ///< those that are open
  std::map<std::uint32_t, std::string> sent;
  std::set<std::uint32_t> ending;  ///< to be closed as soon as all is sent
  std::set<std::uint32_t> timers;  ///< those that are set
  std::vector<float> played;       ///< the samples that were written
  std::size_t unheard = 0;         ///< how many of these are still to be heard

  /// Closes the socket, as the server or finish() asked for.
  void close(std::uint32_t socket);
  /// Lets all timers ring that are set.
  void ring();
};

/// The only one.
[[nodiscard]] FakeBrowser& fake_browser();

}  // namespace aucast::test
