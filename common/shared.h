#pragma once

#include <condition_variable>
#include <mutex>
#if __has_include(<stop_token>)
#include <stop_token>
#endif
#include <utility>

#include "common/time.h"

namespace aucast {

/// Data that several threads use, behind a lock. Only an act, a function that is passed in, can get
/// at the data, and only one act runs at a time. An act is short and waits for nothing. All our
/// locks are in objects of this class, except that of the log's sink (stderr_sink.h).
template <typename T>
class Shared {
 public:
  template <typename... Parts>
  explicit Shared(Parts&&... parts) : value_{std::forward<Parts>(parts)...} {}
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  template <typename Act>
  auto with(Act act) {
    const std::lock_guard lock(mutex_);
    return act(value_);
  }
  template <typename Act>
  auto with(Act act) const {
    const std::lock_guard lock(mutex_);
    return act(value_);
  }
  /// As with(), but also wakes the waiting threads.
  template <typename Act>
  auto change(Act act) {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
    return act(value_);
  }
  void wake() { changed_.notify_all(); }

  /// Waits until `ready` returns true, then acts. change() and wake() make it ask `ready` again.
  template <typename Ready, typename Act>
  auto wait(Ready ready, Act act) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return ready(std::as_const(value_)); });
    return act(value_);
  }
  /// The same, but acts at `until` at the latest, ready or not.
  template <typename Ready, typename Act>
  auto wait_until(Instant until, Ready ready, Act act) {
    std::unique_lock lock(mutex_);
    changed_.wait_until(lock, until, [&] { return ready(std::as_const(value_)); });
    return act(value_);
  }
#if __has_include(<stop_token>)  // see common/stopped.h
  /// The same two, but they also act, ready or not, once a stop has been requested.
  template <typename Ready, typename Act>
  auto wait(const std::stop_token& stop, Ready ready, Act act) {
    const std::stop_callback stopped(stop, [this] { change([](T&) {}); });
    return wait([&](const T& value) { return stop.stop_requested() || ready(value); }, act);
  }
  template <typename Ready, typename Act>
  auto wait_until(const std::stop_token& stop, Instant until, Ready ready, Act act) {
    const std::stop_callback stopped(stop, [this] { change([](T&) {}); });
    return wait_until(
        until, [&](const T& value) { return stop.stop_requested() || ready(value); }, act);
  }
#endif

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  T value_;
};

}  // namespace aucast
