#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "common/result.h"
#include "common/shared.h"
#include "common/task.h"

namespace aucast::app {

/// Does one long piece of work at a time on a thread of its own. It says how far the work is, and
/// can cancel it. Thread: the player's.
class BackgroundWork {
 public:
  /// How much is done, and how much there is to do; both are 0 while that is not known.
  struct Reached {
    std::size_t done = 0;
    std::size_t total = 0;
  };
  /// What the work shares with its owner. The work calls these functions from its own thread.
  class Course {
   public:
    void reached(std::size_t done, std::size_t total) {
      reached_.with([&](Reached& now) { now = {done, total}; });
    }
    [[nodiscard]] bool cancelled() const { return cancel_.stop_requested(); }
    /// For work that waits: a token that asks for a stop when the work is cancelled.
    [[nodiscard]] std::stop_token stop() const { return cancel_.get_token(); }

   private:
    friend class BackgroundWork;
    Shared<Reached> reached_;
    std::stop_source cancel_;
  };
  /// Returns a sentence about what was made. An exception counts as a failure.
  using Work = std::function<Result<std::string>(Course&)>;

  BackgroundWork() = default;
  /// Cancels the work and waits for its end.
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Begins the work. Must not be called while running(). Fails if no thread can be started.
  [[nodiscard]] Result<void> begin(Work work);
  /// Asks the work to end soon.
  void cancel();
  /// Waits until the work has ended.
  void wait() const { task_.wait(); }
  [[nodiscard]] bool running() const { return task_.running(); }
  [[nodiscard]] bool cancelled() const { return course_ != nullptr && course_->cancelled(); }
  [[nodiscard]] Reached reached() const;
  /// Returns the result once, after the work has ended. running() is true until then.
  [[nodiscard]] std::optional<Result<std::string>> take_outcome() { return task_.take(); }

 private:
  std::unique_ptr<Course> course_;
  Task<Result<std::string>> task_;
};

}  // namespace aucast::app
