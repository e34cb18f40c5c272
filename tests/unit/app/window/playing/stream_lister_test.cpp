#include "client/app/window/playing/stream_lister.h"

#include <gtest/gtest.h>

#include <thread>

namespace aucast::app {
namespace {

using Names = std::vector<std::string>;

void answered(StreamLister& lister) {
  while (lister.view().asking) {
    lister.advance();
    std::this_thread::yield();
  }
}

TEST(StreamLister, ShowsTheNamesThatCame) {
  StreamLister lister([](const net::RemoteOptions&) { return Names{"talk", "lecture"}; });
  EXPECT_FALSE(lister.view().asking);
  lister.ask({});
  EXPECT_TRUE(lister.view().asking);
  answered(lister);
  EXPECT_EQ(lister.view().names, (Names{"talk", "lecture"}));
}

TEST(StreamLister, SaysWhyThereAreNone) {
  StreamLister lister([](const net::RemoteOptions&) -> Result<Names> {
    return Error{ErrorKind::Network, "cannot be reached"};
  });
  lister.ask({});
  answered(lister);
  EXPECT_EQ(lister.view().problem, "cannot be reached");
  EXPECT_TRUE(lister.view().names.empty());
}

TEST(StreamLister, TheLastQuestionCountsAndNobodyWaitsLong) {
  Duration longest{0};
  StreamLister lister([&](const net::RemoteOptions& server) {
    longest = std::max(longest, server.connect_timeout);
    return Names{server.host};
  });
  net::RemoteOptions server;
  for (const char* host : {"a", "b", "c"}) {
    server.host = host;
    lister.ask(server);
  }
  answered(lister);
  EXPECT_EQ(lister.view().names, Names{"c"});
  EXPECT_LE(longest, StreamLister::kTimeMax);
}

}  // namespace
}  // namespace aucast::app
