#include "client/app/window/leaving.h"

#include <utility>

namespace aucast::app {

void Leaving::wish(const Losses& losses) {
  next_ = losses.any() ? Next::Asks : Next::Leaves;
}

void Leaving::answer(const gui::Leave& answer, const Losses& losses, bool choosing) {
  once_saved_ = answer.saves && choosing;
  if (answer.really || (answer.saves && !losses.any())) {
    next_ = Next::Leaves;
  } else {
    // What saving cannot end is asked about on its own.
    next_ = answer.saves && !losses.unsaved ? Next::Asks : Next::Stays;
  }
}

void Leaving::chosen(const Losses& losses) {
  if (std::exchange(once_saved_, false) && !losses.unsaved) wish(losses);
}

void Leaving::look(const Losses& losses) {
  if (asks() && !losses.any()) next_ = Next::Stays;
}

}  // namespace aucast::app
