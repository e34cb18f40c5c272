#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <system_error>
#include <utility>

#include "common/result.h"
#include "common/text.h"

namespace aucast {

/// One piece of work at a time on a thread of its own, and its answer, which is asked for now and
/// then. The destructor waits for it. Thread: that of its owner.
template <typename T>
class Task {
 public:
  /// Only while nothing is running(). Failed when the system has no thread left. `work` throws
  /// nothing.
  [[nodiscard]] Result<void> start(std::function<T()> work) {
    try {
      answer_ = std::async(std::launch::async, std::move(work));
    } catch (const std::system_error& failure) {
      return Error{ErrorKind::Failed, shortage_text(failure)};
    }
    return {};
  }
  [[nodiscard]] bool running() const { return answer_.valid(); }
  void wait() const {
    if (running()) answer_.wait();
  }
  /// Once, when it is there: the task no longer runs then.
  [[nodiscard]] std::optional<T> take() {
    if (!running() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return std::nullopt;
    }
    return answer_.get();
  }

 private:
  std::future<T> answer_;
};

}  // namespace aucast
