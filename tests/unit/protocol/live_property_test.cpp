// Live sessions against the client's state machine over queues that cut and delay at random:
// whatever is left out, what arrives is true, in order and never stale when the way is free.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "protocol/client_session.h"
#include "protocol/live_replay.h"
#include "protocol/server_session.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::Seeded;

/// AU 1 counts the keyframes in percent, so that each state is known by its number.
std::vector<Keyframe> numbered(int length) {
  std::vector<Keyframe> keyframes;
  for (int n = 1; n <= length; ++n) {
    Keyframe keyframe;
    keyframe.terms = {{1, Side::Both, static_cast<std::uint8_t>(n)}, {6, Side::Left, 50}};
    keyframe.time_ms = 10;
    keyframes.push_back(keyframe);
  }
  return keyframes;
}

class LivePair {
 public:
  LivePair(Seeded& seeded, int length) : seeded_(seeded) {
    const ServedStream stream = test::served("numbered", test::encoded(numbered(length), 0));
    live_ = std::make_shared<LiveReplay>(stream.recorded()->encoded, false, now_);
    catalogue_.streams.push_back({stream.name, live_});
    server_.emplace(catalogue_, 0ms, now_);
    ClientSessionOptions options;
    options.hello.window = seeded.integer(0, 5);
    options.hello.delta = seeded.chance(0.7);
    options.silence_max = 24h;
    client_.emplace(options);
    take(client_->on_connected(now_));
    take(server_->on_bytes(std::exchange(to_server_, {}), now_));
  }

  bool run(int steps_max) {
    for (int step = 0; step < steps_max && !ended; ++step) move();
    return ended;
  }

  std::vector<int> seen;  ///< numbers of the states
  bool ended = false;
  [[nodiscard]] std::uint64_t merged() const { return server_->sent().keyframes_merged; }
  [[nodiscard]] std::uint64_t sent() const { return server_->sent().keyframes; }

 private:
  void move() {
    switch (seeded_.integer(0, 4)) {
      case 0:
        now_ += Milliseconds(seeded_.integer(0, 25));
        while (live_->advance(now_)) take(server_->on_moment(now_));
        break;
      case 1:
        deliver();
        break;
      case 2:
        take(server_->on_bytes(std::exchange(to_server_, {}), now_));
        break;
      case 3:
        take(server_->set_blocked(seeded_.chance(0.3), now_));
        break;
      default:
        speak();
        break;
    }
  }

  void deliver() {
    const auto count = static_cast<std::size_t>(seeded_.integer(1, 60));
    const std::string portion = to_client_.substr(0, count);
    to_client_.erase(0, portion.size());
    if (!portion.empty()) take(test::read_all(*client_, portion));
  }

  void speak() {
    if (seeded_.chance(0.2)) to_server_ += client_->pause();
    to_server_ += client_->answer_received();
    if (seeded_.chance(0.5)) to_server_ += client_->resume();
  }

  void take(const std::vector<ServerEvent>& events) {
    for (const ServerEvent& event : events) {
      if (const auto* send = std::get_if<SendBytes>(&event)) to_client_ += send->bytes;
      if (const auto* close = std::get_if<CloseConnection>(&event)) {
        ASSERT_EQ(close->why, CloseConnection::Why::Finished) << close->reason;
      }
    }
  }

  void take(const std::vector<ClientEvent>& events) {
    for (const ClientEvent& event : events) {
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        to_server_ += send->bytes;
      } else if (const auto* keyframe = std::get_if<DeliverKeyframe>(&event)) {
        EXPECT_FLOAT_EQ(keyframe->aus.left[6], 0.5F);
        seen.push_back(static_cast<int>(std::lround(keyframe->aus.left[1] * 100)));
      } else if (const auto* failed = std::get_if<SessionFailed>(&event)) {
        ADD_FAILURE() << failed->reason;
        ended = true;
      } else if (std::holds_alternative<StreamEnded>(event)) {
        ended = true;
      }
    }
  }

  Seeded& seeded_;
  Instant now_ = Instant{} + 1h;
  ServerCatalogue catalogue_;
  std::shared_ptr<LiveReplay> live_;
  std::optional<ServerSession> server_;
  std::optional<ClientSession> client_;
  std::string to_client_;
  std::string to_server_;
};

TEST(LiveSessions, TellTheTruthInOrderAndEndWithTheLastState) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::uint64_t merged = 0;
  for (int run = 0; run < 500; ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    const int length = seeded.integer(1, 90);
    LivePair pair(seeded, length);
    ASSERT_TRUE(pair.run(100'000));
    EXPECT_EQ(pair.seen.size(), pair.sent());
    for (std::size_t i = 1; i < pair.seen.size(); ++i) {
      ASSERT_LT(pair.seen[i - 1], pair.seen[i]) << "states only get newer";
    }
    // It may have come after the end; then it saw nothing.
    if (!pair.seen.empty()) {
      EXPECT_EQ(pair.seen.back(), length);
      EXPECT_EQ(pair.seen.size() + pair.merged(),
                static_cast<std::size_t>(length - pair.seen.front() + 1))
          << "each state was sent or counted as left out";
    }
    merged += pair.merged();
  }
  EXPECT_GT(merged, 100U) << "leaving out must have been met";
}

}  // namespace
}  // namespace aucast::protocol
