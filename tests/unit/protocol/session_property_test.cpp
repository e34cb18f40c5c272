// Drives a ClientSession against a ServerSession in memory, over two byte queues that cut and delay
// at random. Whatever the owner does in between, nothing may be lost, doubled or reordered, and
// both sides must end.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "protocol/client_session.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/server_session.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::Seeded;

/// The moves of one run: how likely each is in a step.
struct Temper {
  double pausing = 0.1;
  double passing_time = 0.2;
  double stopping = 0;  ///< the client's -4
  double server_stopping = 0;
};

class Wire {
 public:
  void write(std::string_view bytes) { waiting_ += bytes; }
  std::string read_some(Seeded& seeded) {
    const auto count = static_cast<std::size_t>(seeded.integer(1, 40));
    std::string portion = waiting_.substr(0, count);
    waiting_.erase(0, portion.size());
    return portion;
  }
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

 private:
  std::string waiting_;
};

class Pair {
 public:
  Pair(const ServerCatalogue& catalogue, const ClientSessionOptions& options, Seeded& seeded,
       Temper temper)
      : seeded_(seeded),
        temper_(temper),
        server_(catalogue, std::chrono::milliseconds(seeded.integer(0, 200)), now_),
        client_(options) {
    take(client_.on_connected(now_));
  }

  /// Steps until both sides are through; false when they are not after `steps_max`.
  bool run(int steps_max) {
    for (int step = 0; step < steps_max && !(client_over_ && server_over_); ++step) move();
    return client_over_ && server_over_;
  }

  std::vector<AuFrame> stored;
  std::string client_end;
  std::string server_end;
  bool client_stopped = false;

  [[nodiscard]] const ServerSession& server() const { return server_; }
  [[nodiscard]] const ClientSession& client() const { return client_; }

 private:
  void move() {
    now_ += std::chrono::milliseconds(seeded_.chance(temper_.passing_time) ? 50 : 0);
    take(server_.on_time(now_));
    take(client_.on_time(now_));
    switch (seeded_.integer(0, 3)) {
      case 0:
        deliver_to_client();
        break;
      case 1:
        deliver_to_server();
        break;
      default:
        act();
        break;
    }
  }

  void deliver_to_client() {
    if (!to_client_.empty()) {
      take(test::read_all(client_, to_client_.read_some(seeded_)));
    } else if (server_over_) {
      take(client_.on_closed());
      end_client();
    }
  }

  void deliver_to_server() {
    if (!to_server_.empty()) {
      take(server_.on_bytes(to_server_.read_some(seeded_), now_));
    } else if (client_over_ && !server_over_) {
      take(server_.on_peer_end(now_));
    }
  }

  void act() {
    if (client_over_) return;
    ASSERT_LE(client_.unanswered(), static_cast<std::size_t>(client_.window()));
    if (seeded_.chance(temper_.stopping)) {
      client_stopped = true;
      to_server_.write(client_.stop());
    } else if (seeded_.chance(temper_.server_stopping)) {
      take(server_.stop(now_));
    } else if (seeded_.chance(temper_.pausing)) {
      to_server_.write(client_.pause());
    } else if (client_.paused()) {
      to_server_.write(client_.resume());
    } else {
      to_server_.write(client_.answer_received());
    }
    // In level 2 a pause answers nothing: the answers go on.
    if (client_.paused() && client_.level() == Level::Negotiated) {
      to_server_.write(client_.answer_received());
    }
  }

  void take(const std::vector<ServerEvent>& events) {
    for (const ServerEvent& event : events) {
      ASSERT_FALSE(server_over_) << "an event after the close";
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        to_client_.write(send->bytes);
      } else if (const auto* close = std::get_if<CloseConnection>(&event)) {
        server_over_ = true;
        server_end = std::string(name(close->why)) + ": " + close->reason;
      }
    }
  }

  void take(const std::vector<ClientEvent>& events) {
    for (const ClientEvent& event : events) {
      ASSERT_FALSE(client_over_) << "an event after the end";
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        to_server_.write(send->bytes);
      } else if (const auto* keyframe = std::get_if<DeliverKeyframe>(&event)) {
        stored.push_back(keyframe->aus);
      } else if (!std::holds_alternative<Granted>(event)) {
        client_end = test::text_of({event}) + test::reason_of(events);
        end_client();
      }
    }
  }

  void end_client() { client_over_ = true; }

  Seeded& seeded_;
  Temper temper_;
  Instant now_ = Instant{} + 1h;
  ServerSession server_;
  ClientSession client_;
  Wire to_client_;
  Wire to_server_;
  bool server_over_ = false;
  bool client_over_ = false;
};

/// A stream in which every keyframe differs from its neighbours: AU n%29+1 at n/29+1 percent.
ServedStream numbered_stream(int length) {
  std::vector<Keyframe> keyframes;
  for (int n = 0; n < length; ++n) {
    Keyframe keyframe;
    keyframe.terms = {
        {static_cast<std::uint8_t>(n % 29 + 1), Side::Both, static_cast<std::uint8_t>(n / 29 + 1)}};
    keyframes.push_back(std::move(keyframe));
  }
  EncodedStream stream = test::encoded(keyframes, 0);
  stream.changes = {};
  return test::served("numbered", std::move(stream));
}

std::string sets_of(const std::vector<AuFrame>& frames) {
  std::string text;
  for (const AuFrame& frame : frames) text += '{' + format_au_set(frame) + '}';
  return text;
}

std::string sent_by(const ServedStream& stream, Level level, std::size_t count) {
  const auto& packets = level == Level::Classic ? stream.recorded()->encoded->classic
                                                : stream.recorded()->encoded->negotiated;
  std::string text;
  for (std::size_t n = 0; n < count; ++n) text += packets[n % packets.size()];
  return text;
}

ClientSessionOptions random_options(Seeded& seeded) {
  ClientSessionOptions options;
  options.negotiate = seeded.chance(0.7);
  options.hello.window = seeded.chance(0.2) ? kWindowMax : seeded.integer(0, 8);
  // The run may keep the client waiting for long: silence has its own tests.
  options.silence_max = 24h;
  return options;
}

TEST(Sessions, LoseDoubleAndReorderNothingAndBothEnd) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  int negotiated = 0;
  for (int run = 0; run < 3000; ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    ServerCatalogue catalogue;
    catalogue.streams = {numbered_stream(seeded.integer(1, 60))};
    Pair pair(catalogue, random_options(seeded), seeded, {});
    ASSERT_TRUE(pair.run(100'000)) << pair.client_end << " / " << pair.server_end;
    const Level level = pair.client().level();
    negotiated += level == Level::Negotiated ? 1 : 0;
    const ServedStream& stream = catalogue.streams.front();
    EXPECT_EQ(pair.client_end, "ended");
    EXPECT_EQ(pair.server_end, "finished: the stream was sent whole");
    EXPECT_EQ(level, pair.server().level());
    EXPECT_EQ(sets_of(pair.stored),
              sent_by(stream, level, stream.recorded()->encoded->classic.size()));
    EXPECT_EQ(pair.client().keyframes_received(), pair.server().sent().keyframes);
    EXPECT_EQ(pair.client().payload_bytes(), pair.server().sent().payload_bytes);
  }
  EXPECT_GT(negotiated, 500) << "both levels must have been met";
  EXPECT_LT(negotiated, 2500);
}

TEST(Sessions, EndProperlyWhenEitherSideStops) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 2000; ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    ServerCatalogue catalogue;
    catalogue.streams = {numbered_stream(seeded.integer(1, 60))};
    catalogue.loop = true;
    Temper temper;
    (seeded.chance(0.5) ? temper.stopping : temper.server_stopping) = 0.03;
    Pair pair(catalogue, random_options(seeded), seeded, temper);
    ASSERT_TRUE(pair.run(100'000)) << pair.client_end << " / " << pair.server_end;
    EXPECT_EQ(pair.client_end, "ended");
    EXPECT_TRUE(pair.server_end.starts_with("stopped: ")) << pair.server_end;
    EXPECT_EQ(sets_of(pair.stored),
              sent_by(catalogue.streams.front(), pair.client().level(), pair.stored.size()));
    if (!pair.client_stopped) {
      EXPECT_EQ(pair.stored.size(), pair.server().sent().keyframes) << "last words are never lost";
    }
  }
}

}  // namespace
}  // namespace aucast::protocol
