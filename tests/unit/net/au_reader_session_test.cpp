// The reader against the real server's session, joined in memory: whatever the sizes, the portions
// and the order of things, every keyframe comes through once and in order.

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "client/net/au_reader.h"
#include "protocol/server_session.h"
#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"
#include "tests/unit/net/reader_options.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using aucast::test::Seeded;
using playback::EndReason;

/// Keyframe n shows AU 1 + n % 99, so that a gap or a double is seen.
int au_of(int keyframe) {
  return 1 + keyframe % 99;
}

protocol::ServerCatalogue catalogue_of(int count) {
  protocol::EncodedStream stream;
  for (int i = 0; i < count; ++i) {
    const std::string packet = "{" + std::to_string(au_of(i)) + "}";
    stream.classic.push_back(packet);
    stream.negotiated.push_back(packet);
  }
  protocol::ServerCatalogue catalogue;
  catalogue.streams.push_back(
      {"numbers", protocol::RecordedStream{
                      std::make_shared<const protocol::EncodedStream>(std::move(stream))}});
  return catalogue;
}

/// One direction of a connection: takes bytes in and gives them out in portions of any size.
class Wire {
 public:
  void put(std::string_view bytes) { bytes_ += bytes; }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  std::string get(Seeded& seeded) {
    const auto size = static_cast<std::size_t>(seeded.integer(1, static_cast<int>(bytes_.size())));
    const std::string portion = bytes_.substr(0, size);
    bytes_.erase(0, size);
    return portion;
  }

 private:
  std::string bytes_;
};

/// How a conversation comes to its end.
enum class Fate { StreamEnds, ServerStops, ConnectionBreaks };

class Loop {
 public:
  Loop(const protocol::ServerCatalogue& catalogue, const AuReaderOptions& options, Fate fate,
       Seeded& seeded)
      : seeded_(seeded), fate_(fate), server_(catalogue, 1ms, clock_.now()), reader_(options) {
    carry_out(reader_.connected(clock_.now()));
  }

  /// Plays everything in a random order of events; the marks of the keyframes taken.
  std::vector<int> play() {
    std::vector<int> taken;
    const double eager = seeded_.real(0.05, 0.95);
    for (int step = 0; step < 200'000 && !over(); ++step) {
      clock_.advance(std::chrono::microseconds(seeded_.integer(0, 2'000)));
      serve_time();
      if (seeded_.chance(0.005)) meet_fate();
      if (!to_server_.empty() && seeded_.chance(0.5)) {
        carry_out(server_.on_bytes(to_server_.get(seeded_), clock_.now()));
      }
      if (!to_reader_.empty() && reader_.wants_bytes() && seeded_.chance(0.5)) {
        carry_out(reader_.received(to_reader_.get(seeded_), clock_.now()));
      }
      if (seeded_.chance(0.01)) reader_.set_paused(paused_ = !paused_);
      if (paused_ && seeded_.chance(0.1)) reader_.set_paused(paused_ = false);
      if (seeded_.chance(eager)) {
        if (const auto keyframe = reader_.take()) taken.push_back(mark_of(*keyframe));
      }
      if (reader_.has_output()) carry_out(reader_.speak(clock_.now()));
    }
    return taken;
  }

  [[nodiscard]] playback::SourceStatus status() const { return reader_.status(); }

 private:
  static int mark_of(const playback::Keyframe& keyframe) {
    const auto& right = keyframe.aus.right;  // AUs without a side may be the right one's alone
    return static_cast<int>(std::find(right.begin(), right.end(), 1.0F) - right.begin());
  }
  [[nodiscard]] bool over() const {
    const auto now = reader_.status();
    return now.end != EndReason::NotEnded && now.receiver_fill + now.playout_fill == 0;
  }
  void meet_fate() {
    if (reader_.status().keyframes_received < 2) return;
    if (fate_ == Fate::ServerStops) carry_out(server_.stop(clock_.now()));
    if (fate_ == Fate::ConnectionBreaks) carry_out(reader_.closed(clock_.now()));
  }
  void serve_time() {
    const auto server_due = server_.deadline();
    if (server_due && *server_due <= clock_.now()) carry_out(server_.on_time(clock_.now()));
    const auto reader_due = reader_.deadline();
    if (reader_due && *reader_due <= clock_.now()) carry_out(reader_.time(clock_.now()));
  }
  void carry_out(const std::vector<protocol::ServerEvent>& events) {
    for (const auto& event : events) {
      if (const auto* send = std::get_if<protocol::SendBytes>(&event)) to_reader_.put(send->bytes);
      if (const auto* close = std::get_if<protocol::CloseConnection>(&event)) {
        EXPECT_NE(close->why, protocol::CloseConnection::Why::ProtocolError) << close->reason;
      }
    }
  }
  void carry_out(const Reaction& reaction) {
    to_server_.put(reaction.send);
    EXPECT_NE(reaction.next, Reaction::Next::Reconnect);
  }

  Seeded& seeded_;
  Fate fate_;
  ManualClock clock_;
  protocol::ServerSession server_;
  AuReader reader_;
  Wire to_server_;
  Wire to_reader_;
  bool paused_ = false;
};

playback::BufferOptions random_buffers(Seeded& seeded) {
  const int receiver = seeded.chance(0.4) ? seeded.integer(1, 3) : seeded.integer(1, 150);
  playback::BufferOptions buffers;
  buffers.receiver_capacity = static_cast<std::size_t>(receiver);
  buffers.playout_capacity = static_cast<std::size_t>(seeded.integer(1, receiver));
  buffers.threshold_percent = seeded.chance(0.3) ? 100 : seeded.integer(1, 100);
  return buffers;
}

/// Plays a stream of random length to its fate: what was received has been taken, all of it, once
/// and in order.
void play_to(Fate fate, Seeded& seeded) {
  const playback::BufferOptions buffers = random_buffers(seeded);
  const bool classic = seeded.chance(0.5);
  const int count = seeded.integer(1, 400);
  SCOPED_TRACE(::testing::Message()
               << "buffer " << buffers.receiver_capacity << " playout " << buffers.playout_capacity
               << " threshold " << buffers.threshold_percent << " count " << count
               << (classic ? " classic" : " level 2"));

  const protocol::ServerCatalogue catalogue = catalogue_of(count);
  Loop loop(catalogue, test::reader_options(classic, buffers), fate, seeded);
  const std::vector<int> taken = loop.play();

  const auto status = loop.status();
  const bool lost = status.end == EndReason::ConnectionLost;
  ASSERT_TRUE(status.end == EndReason::EndOfStream || (lost && fate == Fate::ConnectionBreaks))
      << status.detail;
  ASSERT_EQ(taken.size(), status.keyframes_received);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    ASSERT_EQ(taken[i], au_of(static_cast<int>(i))) << "keyframe " << i;
  }
  if (fate == Fate::StreamEnds) {
    EXPECT_EQ(taken.size(), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(status.negotiated, !classic);
}

TEST(AuReaderSession, EverythingComesThroughOnceAndInOrder) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 150; ++round) play_to(Fate::StreamEnds, seeded);
}

TEST(AuReaderSession, WhatCameBeforeTheServerStoppedIsPlayed) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 100; ++round) play_to(Fate::ServerStops, seeded);
}

TEST(AuReaderSession, WhatCameBeforeTheConnectionBrokeIsPlayed) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 100; ++round) play_to(Fate::ConnectionBreaks, seeded);
}

// A legal stream with a few bytes changed: an error, another legal stream, or waiting for more;
// what is said of it holds no raw byte.
TEST(AuReaderSession, BearsDamagedBytes) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 500; ++round) {
    std::string bytes = seeded.chance(0.5) ? "{hello v=2 window=4 keyframe=80}" : "";
    for (int i = seeded.integer(1, 40); i > 0; --i) bytes += "{1,6:50,12;40}";
    bytes += "{-2}";
    for (int i = seeded.integer(1, 4); i > 0; --i) {
      const auto at =
          static_cast<std::size_t>(seeded.integer(0, static_cast<int>(bytes.size()) - 1));
      bytes[at] = static_cast<char>(seeded.integer(-128, 127));
    }
    ManualClock clock;
    const bool classic = seeded.chance(0.5);
    AuReader reader(test::reader_options(classic, random_buffers(seeded)));
    static_cast<void>(reader.connected(clock.now()));
    Wire wire;
    wire.put(bytes);
    std::uint64_t taken = 0;
    const auto play = [&] {
      while (reader.take()) {
        ++taken;
        if (reader.has_output()) static_cast<void>(reader.speak(clock.now()));
      }
    };
    while (!wire.empty()) {
      static_cast<void>(reader.received(wire.get(seeded), clock.now()));
      if (seeded.chance(0.7)) play();
    }
    play();
    static_cast<void>(reader.closed(clock.now()));
    play();
    const auto status = reader.status();
    ASSERT_LE(taken, 42U);
    ASSERT_TRUE(taken == status.keyframes_received || status.end == EndReason::NotEnded ||
                status.end == EndReason::ProtocolError);
    for (const char byte : status.detail) ASSERT_TRUE(byte >= ' ' && byte < '\x7f');
  }
}

}  // namespace
}  // namespace aucast::net
