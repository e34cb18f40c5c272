// A model of the whole conversation: ClientSession and ServerSession against each other over a link
// that delays, cuts, goes down, breaks, dies at one end or brings garbage. Whatever happens, what
// the client stores is what the stream has, nothing lost, doubled or reordered up to the fault, and
// both sides end. AUCAST_STEPS says how many moves are made in all (a million), AUCAST_SEED which.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "protocol/client_session.h"
#include "protocol/codec.h"
#include "protocol/live_replay.h"
#include "protocol/server_session.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/faulty_link.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::FaultyLink;
using test::Seeded;

enum class Fault {
  None,
  Outage,           ///< nothing gets through for 20 s, then everything
  Reset,            ///< both sides see it, what was on its way is lost
  ServerDies,       ///< the client sees the end after what was on its way
  ClientDies,       ///< the other way round
  GarbageToServer,  ///< bytes that the client did not say
  GarbageToClient,  ///< bytes that the server did not say
  ClientStops,      ///< no fault of the link: -4
  ServerStops,
};
constexpr int kFaults = 9;

/// Whether the stream may be told by the clock of all, and how the two want to talk.
struct Setting {
  Fault fault = Fault::None;
  int fault_at = 0;  ///< the move
  bool live = false;
  int length = 1;
  double pausing = 0;
  ClientSessionOptions options;

  [[nodiscard]] std::string text() const {
    return "fault " + std::to_string(static_cast<int>(fault)) + " at " + std::to_string(fault_at) +
           (live ? ", live" : ", recorded") + ", " + std::to_string(length) +
           " keyframes, window " + std::to_string(options.hello.window) +
           (options.negotiate ? "" : ", classic");
  }
};

Setting random_setting(Seeded& seeded) {
  Setting setting;
  setting.fault = static_cast<Fault>(seeded.integer(0, kFaults - 1));
  setting.fault_at = seeded.integer(0, 400);
  setting.live = seeded.chance(0.3);
  setting.length = seeded.integer(1, 60);
  setting.pausing = seeded.chance(0.5) ? seeded.real(0, 0.3) : 0;
  setting.options.negotiate = seeded.chance(0.7);
  setting.options.hello.window = seeded.chance(0.2) ? 256 : seeded.integer(0, 8);
  setting.options.hello.delta = seeded.chance(0.5);
  return setting;
}

/// Every keyframe differs from all others: AU n at n + 10 percent, and one that comes and goes.
std::vector<Keyframe> countable(int length) {
  std::vector<Keyframe> keyframes;
  for (int n = 1; n <= length; ++n) {
    Keyframe keyframe;
    keyframe.terms = {
        {static_cast<std::uint8_t>(n), Side::Both, static_cast<std::uint8_t>(n + 10)}};
    if (n % 3 == 0) keyframe.terms.push_back({99, Side::Left, 50});
    keyframe.time_ms = 20;
    keyframes.push_back(keyframe);
  }
  return keyframes;
}

/// The number of a stored keyframe; 0 when it is none of the stream, as it was sent in `level`.
int number_of(const AuFrame& aus, Level level, int length) {
  int number = 0;
  for (int au = 1; au <= length; ++au) {
    const auto at = static_cast<std::size_t>(au);
    const bool whole = aus.left[at] == aus.right[at] || shows_on_one_side(au);
    if (aus.right[at] > 0 && whole) number = number == 0 ? au : -1;
  }
  if (number <= 0) return 0;
  Keyframe expected = countable(number).back();
  if (level == Level::Classic) {
    for (AuTerm& term : expected.terms) {
      term.side = Side::Both;
      term.percent = 100;
    }
  }
  return format_au_set(frame_from_terms(expected.terms)) == format_au_set(aus) ? number : 0;
}

class Model {
 public:
  Model(Seeded& seeded, const Setting& setting)
      : seeded_(seeded),
        setting_(setting),
        to_client_(seeded, Milliseconds(seeded.integer(0, 300))),
        to_server_(seeded, Milliseconds(seeded.integer(0, 300))) {
    catalogue_.streams = {test::served("numbered", test::encoded(countable(setting.length), 0))};
    if (setting.live) {
      ServedStream& stream = catalogue_.streams.front();
      live_ = std::make_shared<LiveReplay>(stream.recorded()->encoded, false, now_);
      stream = {stream.name, live_};
    }
    server_.emplace(catalogue_, Milliseconds(seeded.integer(0, 600)), now_);
    client_.emplace(setting.options);
    take(client_->on_connected(now_));
  }

  /// Moves until both sides are through, and says after how many; nothing when they are not after
  /// `moves_max`.
  std::optional<int> run(int moves_max) {
    for (moves_ = 0; moves_ < moves_max; ++moves_) {
      if (client_over_ && server_over_) return moves_;
      if (moves_ == setting_.fault_at) strike();
      // Garbage may leave both waiting for each other, as it may say anything; so the host's
      // time-outs are played too.
      if (garbage_ && moves_ == moves_max / 2) break_off();
      move();
      if (::testing::Test::HasFatalFailure()) return std::nullopt;
    }
    return std::nullopt;
  }

  void check() const {
    SCOPED_TRACE(setting_.text() + ": client " + client_end + ", server " + server_end);
    EXPECT_FALSE(client_end.empty());
    EXPECT_FALSE(server_end.empty());
    const std::size_t good = garbage_to_client_ ? true_until_ : stored_.size();
    for (std::size_t i = 0; i < std::min(good, stored_.size()); ++i) {
      ASSERT_GT(stored_[i], 0) << "keyframe " << i << " is none of the stream";
      if (setting_.live) {
        ASSERT_LT(i > 0 ? stored_[i - 1] : 0, stored_[i]) << "newer and newer";
      } else {
        ASSERT_EQ(stored_[i], static_cast<int>(i) + 1) << "nothing lost, doubled or reordered";
      }
    }
    if (setting_.fault == Fault::None || !struck_) check_complete();
  }

  std::string client_end;
  std::string server_end;

 private:
  void check_complete() const {
    EXPECT_EQ(client_end, "ended");
    EXPECT_EQ(server_end, "finished: the stream was sent whole");
    EXPECT_EQ(client_->keyframes_received(), server_->sent().keyframes);
    EXPECT_EQ(client_->payload_bytes(), server_->sent().payload_bytes);
    if (!setting_.live) {
      EXPECT_EQ(stored_.size(), static_cast<std::size_t>(setting_.length));
    } else if (!stored_.empty()) {
      EXPECT_EQ(stored_.back(), setting_.length) << "who was there at the end has the last state";
      EXPECT_EQ(stored_.size() + server_->sent().keyframes_merged,
                static_cast<std::size_t>(setting_.length - stored_.front() + 1));
    }
  }

  void strike() {
    if (setting_.fault == Fault::None || client_over_ || server_over_) return;
    struck_ = true;
    switch (setting_.fault) {
      case Fault::None:
        break;
      case Fault::Outage:
        to_client_.go_down(now_ + 20s);
        to_server_.go_down(now_ + 20s);
        break;
      case Fault::Reset:
        break_off();
        break;
      case Fault::ServerDies:
        server_gone("died");
        break;
      case Fault::ClientDies:
        client_gone("died");
        break;
      case Fault::GarbageToServer:
        garbage_ = true;
        to_server_.write(rubbish(), now_);
        break;
      case Fault::GarbageToClient:
        garbage_ = garbage_to_client_ = true;
        true_until_ = stored_.size();
        to_client_.write(rubbish(), now_);
        break;
      case Fault::ClientStops:
        to_server_.write(client_->stop(), now_);
        break;
      case Fault::ServerStops:
        take(server_->stop(now_));
        break;
    }
  }

  /// Often bytes that mean something.
  std::string rubbish() {
    static constexpr std::string_view kAlphabet = "{}~,:;@-0123456789 \nLRhelo=\xff";
    std::string bytes;
    for (int left = seeded_.integer(1, 60); left > 0; --left) {
      bytes += kAlphabet[static_cast<std::size_t>(
          seeded_.integer(0, static_cast<int>(kAlphabet.size()) - 1))];
    }
    return bytes;
  }

  void break_off() {
    to_client_.cut();
    to_server_.cut();
    if (!server_over_) take(server_->on_lost(now_));
    if (!client_over_) take(client_->on_closed());
    struck_ = true;
  }

  void move() {
    if (seeded_.chance(0.5)) now_ += Milliseconds(seeded_.integer(0, 40));
    if (!server_over_) take(server_->on_time(now_));
    if (!client_over_) take(client_->on_time(now_));
    if (live_ && live_->advance(now_) && !server_over_) take(server_->on_moment(now_));
    switch (seeded_.integer(0, 3)) {
      case 0:
        deliver_to_client();
        break;
      case 1:
        deliver_to_server();
        break;
      case 2:
        if (live_ && !server_over_) take(server_->set_blocked(seeded_.chance(0.3), now_));
        break;
      default:
        act();
        break;
    }
  }

  void deliver_to_client() {
    if (client_over_) return;
    if (const std::string bytes = to_client_.read(now_); !bytes.empty()) {
      take(test::read_all(*client_, bytes));
    } else if (to_client_.at_end()) {
      take(client_->on_closed());
    }
  }

  void deliver_to_server() {
    if (server_over_) return;
    if (const std::string bytes = to_server_.read(now_); !bytes.empty()) {
      take(server_->on_bytes(bytes, now_));
    } else if (to_server_.at_end()) {
      take(server_->on_peer_end(now_));
    }
  }

  /// What a player does: answers, has no room, has room again.
  void act() {
    if (client_over_) return;
    if (!garbage_) {
      ASSERT_LE(client_->unanswered(), static_cast<std::size_t>(std::max(client_->window(), 1)));
    }
    if (seeded_.chance(setting_.pausing)) {
      to_server_.write(client_->pause(), now_);
    } else if (client_->paused()) {
      to_server_.write(client_->resume(), now_);
    } else {
      to_server_.write(client_->answer_received(), now_);
    }
    if (client_->paused() && client_->level() == Level::Negotiated) {
      to_server_.write(client_->answer_received(), now_);
    }
  }

  void take(const std::vector<ServerEvent>& events) {
    for (const ServerEvent& event : events) {
      ASSERT_FALSE(server_over_) << "an event after the close";
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        to_client_.write(send->bytes, now_);
      } else if (const auto* close = std::get_if<CloseConnection>(&event)) {
        server_gone(std::string(name(close->why)) + ": " + close->reason);
      }
    }
  }

  void take(const std::vector<ClientEvent>& events) {
    for (const ClientEvent& event : events) {
      ASSERT_FALSE(client_over_) << "an event after the end";
      if (const auto* send = std::get_if<SendBytes>(&event)) {
        to_server_.write(send->bytes, now_);
      } else if (const auto* keyframe = std::get_if<DeliverKeyframe>(&event)) {
        stored_.push_back(number_of(keyframe->aus, client_->level(), setting_.length));
      } else if (!std::holds_alternative<Granted>(event)) {
        const std::string reason = test::reason_of(events);
        client_gone(test::text_of({event}) + (reason.empty() ? "" : ": " + reason));
      }
    }
  }

  void server_gone(const std::string& how) {
    server_over_ = true;
    server_end = how;
    to_client_.end();
  }

  void client_gone(const std::string& how) {
    client_over_ = true;
    client_end = how;
    to_server_.end();
  }

  Seeded& seeded_;
  Setting setting_;
  int moves_ = 0;
  Instant now_ = Instant{} + 1h;
  ServerCatalogue catalogue_;
  std::shared_ptr<LiveReplay> live_;
  std::optional<ServerSession> server_;
  std::optional<ClientSession> client_;
  FaultyLink to_client_;
  FaultyLink to_server_;
  std::vector<int> stored_;
  std::size_t true_until_ = 0;
  bool struck_ = false;
  bool garbage_ = false;
  bool garbage_to_client_ = false;
  bool server_over_ = false;
  bool client_over_ = false;
};

long steps_wanted() {
  const char* text = std::getenv("AUCAST_STEPS");
  return text == nullptr ? 1'000'000 : std::strtol(text, nullptr, 10);
}

TEST(SessionModel, HoldsOverAFaultyLink) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const long wanted = steps_wanted();
  std::map<std::string, int> ends;
  int runs = 0;
  for (long steps = 0; steps < wanted; ++runs) {
    SCOPED_TRACE("run " + std::to_string(runs));
    const Setting setting = random_setting(seeded);
    Model model(seeded, setting);
    const auto moves = model.run(40'000);
    ASSERT_TRUE(moves.has_value()) << setting.text() << ": no end in sight, client "
                                   << model.client_end << ", server " << model.server_end;
    model.check();
    if (HasFailure()) return;
    steps += *moves;
    ++ends[model.client_end.substr(0, model.client_end.find(':'))];
  }
  std::printf("%d conversations, %ld steps, %s\n", runs, wanted, seeded.trace().c_str());
  for (const auto& [end, count] : ends) std::printf("  %-20s %d\n", end.c_str(), count);
  if (wanted >= 100'000) {
    for (const char* end : {"ended", "fail lost", "reconnect", "died"}) {
      EXPECT_GT(ends[end], 0) << end << " must have been met";
    }
  }
}

}  // namespace
}  // namespace aucast::protocol
