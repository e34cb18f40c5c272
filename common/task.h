#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "common/result.h"
#include "common/thread.h"

namespace aucast {

/// Runs one piece of work at a time on a thread of its own; the owner asks now and then for the
/// answer. The destructor waits for the work to end. Thread: that of its owner.
template <typename T>
class Task {
 public:
  /// Call this only when not running(). Fails with ErrorKind::Failed if the system has no thread
  /// left. `work` must not throw.
  [[nodiscard]] Result<void> start(std::function<T()> work) {
    // Shared, since a std::function is copied.
    const auto task = std::make_shared<std::packaged_task<T()>>(std::move(work));
    auto thread = start_thread([task] { (*task)(); });
    if (!thread) return thread.error();
    thread_ = std::move(*thread);
    answer_ = task->get_future();
    return {};
  }
  [[nodiscard]] bool running() const { return answer_.valid(); }
  void wait() const {
    if (running()) answer_.wait();
  }
  /// Returns nullopt until the answer has come, and then, once, the answer. After that the task is
  /// no longer running(), and the work and all that it owned are destroyed.
  [[nodiscard]] std::optional<T> take() {
    if (!running() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return std::nullopt;
    }
    thread_.join();
    return answer_.get();
  }

 private:
  std::future<T> answer_;
  std::jthread thread_;
};

}  // namespace aucast
