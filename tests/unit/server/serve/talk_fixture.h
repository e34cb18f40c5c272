#pragma once

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "protocol/server_session.h"
#include "tests/support/quiet_log.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::server {

/// A catalogue with one stream, "talk", of the three packets {1}{2}{3}, each for a tenth of a
/// second; and a log that is silent.
class TalkFixture : public ::testing::Test {
 protected:
  TalkFixture() {
    protocol::EncodedStream stream;
    stream.classic = stream.negotiated = test::packets({"{1}", "{2}", "{3}"});
    stream.times.assign(3, protocol::KeyframeTime(100));
    stream_ = std::make_shared<const protocol::EncodedStream>(std::move(stream));
    catalogue_->streams = {{"talk", protocol::RecordedStream{stream_}}};
  }

  const test::QuietLog quiet_;
  std::shared_ptr<const protocol::EncodedStream> stream_;
  std::shared_ptr<protocol::ServerCatalogue> catalogue_ =
      std::make_shared<protocol::ServerCatalogue>();
};

}  // namespace aucast::server
