#include "client/app/window/background_work.h"

#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "common/check.h"
#include "common/text.h"

namespace aucast::app {

BackgroundWork::~BackgroundWork() {
  cancel();
  wait();
}

Result<void> BackgroundWork::begin(Work work) {
  AUCAST_CHECK(!running());
  course_ = std::make_unique<Course>();
  try {
    outcome_ =
        std::async(std::launch::async,
                   [work = std::move(work), course = course_.get()]() -> Result<std::string> {
                     try {
                       return work(*course);
                     } catch (const std::exception& failure) {
                       return Error{ErrorKind::Failed, failure.what()};
                     }
                   });
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Failed, shortage_text(failure)};
  }
  return {};
}

void BackgroundWork::cancel() {
  if (course_ != nullptr) course_->cancelled_ = true;
}

std::optional<Result<std::string>> BackgroundWork::take_outcome() {
  if (!running() || outcome_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return std::nullopt;
  }
  return outcome_.get();
}

}  // namespace aucast::app
