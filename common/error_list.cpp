#include "common/error_list.h"

#include <utility>

#include "common/text.h"

namespace aucast {

void ErrorList::add(std::size_t line, std::size_t column, std::string_view reason) {
  ++count_;
  if (first_.size() < kReportedErrorsMax) first_.push_back(at_place(file_, line, column, reason));
}

Error ErrorList::error() const {
  std::string message;
  for (const std::string& line : first_) message += (message.empty() ? "" : "\n") + line;
  if (count_ > first_.size()) {
    message += '\n' + at_place(file_, 0, 0,
                               "and " + std::to_string(count_ - first_.size()) + " more errors");
  }
  return {ErrorKind::BadData, message};
}

std::vector<std::string> ErrorList::take() {
  count_ = 0;
  return std::exchange(first_, {});
}

}  // namespace aucast
