#include "client/app/window/playing/stream_lister.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using protocol::StreamList;
using Streams = std::vector<protocol::ListedStream>;

void answered(StreamLister& lister) {
  while (lister.view().asking) {
    lister.wait();
    lister.advance();
  }
}

TEST(StreamLister, ShowsTheStreamsThatCame) {
  const Streams all{{"talk", false, 83'000, "A talk"}, {"lecture"}};
  StreamLister lister([&all](const net::RemoteOptions&, Duration) { return StreamList{all}; });
  EXPECT_FALSE(lister.view().asking);
  lister.ask({});
  EXPECT_TRUE(lister.view().asking);
  answered(lister);
  EXPECT_EQ(lister.view().streams, all);
}

TEST(StreamLister, SaysWhyThereAreNone) {
  StreamLister lister([](const net::RemoteOptions&, Duration) -> Result<StreamList> {
    return Error{ErrorKind::Network, "cannot be reached"};
  });
  lister.ask({});
  answered(lister);
  EXPECT_EQ(lister.view().problem, "cannot be reached");
  EXPECT_TRUE(lister.view().streams.empty());
}

TEST(StreamLister, TheLastQuestionCountsAndNobodyWaitsLong) {
  Duration longest{0};
  StreamLister lister([&](const net::RemoteOptions& server, Duration time_max) {
    longest = std::max(longest, time_max);
    return StreamList{{{server.host}}};
  });
  net::RemoteOptions server;
  for (const char* host : {"a", "b", "c"}) {
    server.host = host;
    lister.ask(server);
  }
  answered(lister);
  EXPECT_EQ(lister.view().streams, Streams{{"c"}});
  EXPECT_EQ(longest, StreamLister::kTimeMax);
}

}  // namespace
}  // namespace aucast::app
