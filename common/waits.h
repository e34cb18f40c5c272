#pragma once

#include <cstdint>
#include <memory>
#include <utility>

namespace aucast {

/// Numbers what an object waits for in an event loop, one thing at a time. A handler that is
/// already queued cannot be cancelled, and may run when its owner has gone; so each handler has a
/// Token, and asks that first whether it is still waited for.
/// Thread: that of the event loop.
class Waits {
 public:
  class Token {
   public:
    /// Whether nothing newer has begun, nothing was cancelled, and the owner is still there.
    [[nodiscard]] bool current() const { return *latest_ == number_; }

   private:
    friend class Waits;
    explicit Token(std::shared_ptr<const std::uint64_t> latest)
        : latest_(std::move(latest)), number_(*latest_) {}

    std::shared_ptr<const std::uint64_t> latest_;
    std::uint64_t number_;
  };

  Waits() = default;
  ~Waits() { cancel(); }
  Waits(const Waits&) = delete;
  Waits& operator=(const Waits&) = delete;

  /// Begins another wait; those before are over.
  [[nodiscard]] Token begin() {
    cancel();
    return Token(latest_);
  }
  void cancel() { ++*latest_; }

 private:
  std::shared_ptr<std::uint64_t> latest_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace aucast
