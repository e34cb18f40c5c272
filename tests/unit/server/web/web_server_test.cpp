#include "server/web/web_server.h"

#include <sys/ioctl.h>

#include <cstdlib>

#include <gtest/gtest.h>
#include <asio/read_until.hpp>
#include <asio/write.hpp>

#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

/// How many bytes the system holds that we have sent to this peer and it has not acknowledged. The
/// socket is one of this process.
int held_for(const tcp::endpoint& peer) {
  for (int descriptor = 3; descriptor < 256; ++descriptor) {
    tcp::endpoint there;
    auto size = static_cast<socklen_t>(there.capacity());
    if (::getpeername(descriptor, there.data(), &size) != 0 || there != peer) continue;
    int held = 0;
    return ::ioctl(descriptor, TIOCOUTQ, &held) == 0 ? held : -1;
  }
  return -1;
}

TEST(WebServer, OfALargeFileTheSystemHoldsSoLittleThatASlowClientIsSeenToTakeIt) {
  const test::QuietLog quiet;
  const test::TempFolder folder;
  folder.write("web/index.html", std::string(8'000'000, 'x'));
  ASSERT_EQ(::setenv("AUCAST_DATA", folder.path().c_str(), 1), 0);
  asio::io_context io;
  WebOptions options;
  options.address = HttpAddress{"127.0.0.1", 0};
  const std::optional<tls::Context> no_tls;
  WebServer server(io, options,
                   {[&]() -> const std::optional<tls::Context>& { return no_tls; },
                    [] { return 0; }, [](const tcp::endpoint&, const WebServer::OpenLink&) {}});
  ASSERT_TRUE(server.open(false));
  ::unsetenv("AUCAST_DATA");
  server.start();
  tcp::socket client(io);
  client.open(tcp::v4());
  client.set_option(asio::socket_base::receive_buffer_size(16384));
  client.connect(server.endpoint());
  asio::write(client, asio::buffer(std::string("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")));
  const tcp::endpoint us = client.local_endpoint();
  ASSERT_TRUE(test::run_until(io, [&] { return held_for(us) > 10'000; }));
  // All that the server can do until somebody reads.
  while (io.poll() > 0) {
  }
  EXPECT_LT(held_for(us), 500'000);
}

}  // namespace
}  // namespace aucast::server
