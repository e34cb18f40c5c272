#include "client/app/background_work.h"

#include <exception>
#include <utility>

#include "common/check.h"

namespace aucast::app {

BackgroundWork::~BackgroundWork() {
  cancel();
  wait();
}

Result<void> BackgroundWork::begin(Work work) {
  AUCAST_CHECK(!running());
  course_ = std::make_unique<Course>();
  return task_.start([work = std::move(work), course = course_.get()]() -> Result<std::string> {
    try {
      return work(*course);
    } catch (const std::exception& failure) {
      return Error{ErrorKind::Failed,
                   std::string("the work broke off (") + failure.what() + "); try it again"};
    }
  });
}

void BackgroundWork::cancel() {
  if (course_ != nullptr) course_->cancel_.request_stop();
}

BackgroundWork::Reached BackgroundWork::reached() const {
  if (course_ == nullptr) return {};
  return course_->reached_.with([](const Reached& now) { return now; });
}

}  // namespace aucast::app
