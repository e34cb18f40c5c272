#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "common/link/link.h"
#include "tests/support/manual_clock.h"

namespace aucast::test {

/// A link without a socket and with a clock that stands still: the test is the peer and the time.
class FakeLink final : public link::Link {
 public:
  // === The peer's and the clock's side, for the test.

  void say(std::string_view bytes) { user_->on_bytes(bytes); }
  void end_sending() { user_->on_peer_end(); }
  /// The link closes for the user: after finish(), or by a failure.
  void end(const link::Ending& ending) {
    if (!closed_) std::exchange(user_, nullptr)->on_closed(ending);
    closed_ = true;
  }
  void fail(const link::Ending& failure) { user_->on_failure(failure); }
  /// Lets time pass, and wakes the user whenever it has asked for that.
  void advance(Duration by) {
    const Instant until = clock_.now() + by;
    while (wake_at_ && *wake_at_ <= until && user_ != nullptr && !finished_) {
      clock_.advance(std::max(*wake_at_ - clock_.now(), Duration::zero()));
      wake_at_.reset();
      user_->on_time();
    }
    clock_.advance(until - clock_.now());
  }
  /// The peer takes so many more bytes from now on, and then no more.
  void take(std::size_t bytes) {
    room_ = bytes;
    const std::size_t taken = move_on();
    if (taken > 0) stuck_since_.reset();
    if (waiting_.empty() && taken > 0 && !finished_) user_->on_room();
  }
  /// What the peer has taken since the last call.
  [[nodiscard]] std::string heard() { return std::exchange(taken_, {}); }
  [[nodiscard]] bool started() const { return user_ != nullptr; }
  [[nodiscard]] bool finished() const { return finished_; }
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] bool reading() const { return reading_; }

  bool opens_at_once = true;  ///< else by open()
  void open() { user_->on_open(); }
  Duration round_trip_time{};
  std::function<void()> on_write;  ///< called by write(), if set

  // === The user's side.

  void start(link::LinkUser& user) override {
    user_ = &user;
    if (opens_at_once) open();
  }
  void hand_over(link::LinkUser& user) override { user_ = &user; }
  void write(std::string_view bytes) override {
    if (finished_ || closed_) return;
    waiting_ += bytes;
    move_on();
    if (on_write) on_write();
  }
  void finish() override { finished_ = true; }
  void close() override {
    closed_ = true;
    user_ = nullptr;
  }
  void set_reading(bool reading) override { reading_ = reading; }
  void wake_at(std::optional<Instant> when) override { wake_at_ = when; }
  [[nodiscard]] Instant now() const override { return clock_.now(); }
  [[nodiscard]] Duration round_trip() const override { return round_trip_time; }
  [[nodiscard]] bool blocked() const override { return !waiting_.empty(); }
  [[nodiscard]] std::optional<Instant> stuck_since() const override { return stuck_since_; }
  [[nodiscard]] std::size_t unsent_bytes() const override { return waiting_.size(); }
  [[nodiscard]] std::uint64_t wire_bytes() const override { return wire_bytes_; }

 private:
  std::size_t move_on() {
    const std::size_t count = std::min(room_, waiting_.size());
    taken_ += waiting_.substr(0, count);
    waiting_.erase(0, count);
    room_ -= count;
    wire_bytes_ += count;
    if (waiting_.empty()) stuck_since_.reset();
    if (!waiting_.empty() && !stuck_since_) stuck_since_ = now();
    return count;
  }

  ManualClock clock_;
  link::LinkUser* user_ = nullptr;
  std::string waiting_;
  std::string taken_;
  std::size_t room_ = std::numeric_limits<std::size_t>::max();
  std::optional<Instant> wake_at_;
  std::optional<Instant> stuck_since_;
  std::uint64_t wire_bytes_ = 0;
  bool reading_ = true;
  bool finished_ = false;
  bool closed_ = false;
};

}  // namespace aucast::test
