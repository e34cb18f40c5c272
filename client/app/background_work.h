#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/task.h"

namespace aucast::app {

/// One long piece of work at a time, on a thread of its own, that says how far it is and can be
/// cancelled. Thread: the player's.
class BackgroundWork {
 public:
  /// What the work has to do with its owner, from its own thread.
  class Course {
   public:
    void reached(std::size_t done, std::size_t total) {
      total_ = total;
      done_ = done;
    }
    [[nodiscard]] bool cancelled() const { return cancelled_; }

   private:
    friend class BackgroundWork;
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> total_{0};
    std::atomic<bool> cancelled_{false};
  };
  /// Returns a sentence about what was made. What it throws is a failure.
  using Work = std::function<Result<std::string>(Course&)>;

  BackgroundWork() = default;
  /// Cancels and waits.
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Only while nothing is running(). Failed when there can be no thread.
  [[nodiscard]] Result<void> begin(Work work);
  /// Asks the work to end soon.
  void cancel();
  /// Waits until it is over.
  void wait() const { task_.wait(); }
  [[nodiscard]] bool running() const { return task_.running(); }
  [[nodiscard]] bool cancelled() const { return course_ != nullptr && course_->cancelled_; }
  /// What has been done, and of how much; 0 of 0 while that is not known.
  [[nodiscard]] std::size_t done() const { return course_ == nullptr ? 0 : course_->done_.load(); }
  [[nodiscard]] std::size_t total() const {
    return course_ == nullptr ? 0 : course_->total_.load();
  }
  /// What became of it, once, when it is over: it no longer runs then.
  [[nodiscard]] std::optional<Result<std::string>> take_outcome() { return task_.take(); }

 private:
  std::unique_ptr<Course> course_;
  Task<Result<std::string>> task_;
};

}  // namespace aucast::app
