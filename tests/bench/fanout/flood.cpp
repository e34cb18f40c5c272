#include "tests/bench/fanout/flood.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <string>

#include "tests/bench/fanout/crowd.h"
#include "tests/bench/fanout/processors.h"
#include "tests/support/seeded.h"

namespace aucast::bench {
namespace {

std::string rubbish(test::Seeded& seeded) {
  std::string bytes;
  switch (seeded.integer(0, 7)) {
    case 0:
      bytes.resize(static_cast<std::size_t>(seeded.integer(1, 65536)));
      for (char& byte : bytes) byte = static_cast<char>(seeded.integer(0, 255));
      break;
    case 1:
      bytes =
          "{hello v=2 stream=" + std::string(static_cast<std::size_t>(seeded.integer(0, 600)), 'a');
      break;
    case 2:
      bytes = std::string(static_cast<std::size_t>(seeded.integer(1, 20000)), '1');
      break;
    case 3:
      for (int code = 0; code < 3000; ++code) bytes += code % 2 == 0 ? "-1" : "-3";
      break;
    case 4:
      bytes = "{hello v=2 window=0}";
      break;
    case 5:
      bytes = "GET /metrics HTTP/1.1\r\nHost: x\r\n\r\n";
      break;
    case 6:
      bytes = "GET /status.json HTTP/1.1\r\nCookie: " +
              std::string(static_cast<std::size_t>(seeded.integer(0, 6000)), 'c');
      break;
    default:
      break;
  }
  return bytes;
}

void leave(int socket, bool by_reset) {
  if (by_reset) {
    const linger at_once{1, 0};
    ::setsockopt(socket, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  }
  ::close(socket);
}

}  // namespace

Flood::Flood(std::uint16_t port, int at_a_time) {
  if (at_a_time > 0) thread_ = std::thread([this, port, at_a_time] { run(port, at_a_time); });
}

Flood::~Flood() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Flood::run(std::uint16_t port, int at_a_time) {
  // The crowd shares the machine with this thread, and real floods come from another one.
  stand_back();
  test::Seeded seeded;
  std::deque<int> open;
  while (!stop_) {
    const int socket = connect_to(port, seeded.integer(0, 7));
    if (socket < 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } else {
      const std::string bytes = rubbish(seeded);
      bytes_ += std::max<ssize_t>(::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL), 0);
      ++peers_;
      open.push_back(socket);
    }
    if (static_cast<int>(open.size()) >= at_a_time) {
      leave(open.front(), seeded.chance(0.5));
      open.pop_front();
    }
  }
  for (const int socket : open) leave(socket, true);
}

}  // namespace aucast::bench
