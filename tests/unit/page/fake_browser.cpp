#include "tests/unit/page/fake_browser.h"

#include <utility>

#include "client/web/browser.h"
#include "client/web/socket_link.h"
#include "client/web/timer.h"

namespace aucast::test {

FakeBrowser& fake_browser() {
  static FakeBrowser browser;
  return browser;
}

void FakeBrowser::close(std::uint32_t socket) {
  if (sockets.erase(socket) != 0) web::SocketLink::closed(socket);
}

void FakeBrowser::ring() {
  for (const std::uint32_t timer : std::exchange(timers, {})) web::Timer::ring(timer);
}

}  // namespace aucast::test

namespace aucast::web::browser {

using test::fake_browser;

void open_socket(std::uint32_t socket) {
  fake_browser().sockets.insert(socket);
}

void send(std::uint32_t socket, std::string_view bytes) {
  fake_browser().sent[socket] += bytes;
}

void end_socket(std::uint32_t socket) {
  if (fake_browser().sockets.contains(socket)) fake_browser().ending.insert(socket);
}

void drop_socket(std::uint32_t socket) {
  fake_browser().sockets.erase(socket);
}

void set_timer(std::uint32_t timer, double milliseconds) {
  if (milliseconds < 0) {
    fake_browser().timers.erase(timer);
  } else {
    fake_browser().timers.insert(timer);
  }
}

void write_sound(std::span<const float> samples) {
  fake_browser().played.insert(fake_browser().played.end(), samples.begin(), samples.end());
}

std::size_t unheard_samples() {
  return fake_browser().unheard;
}

}  // namespace aucast::web::browser
