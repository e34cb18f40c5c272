#include "client/app/window/leaving.h"

#include <utility>

namespace aucast::app {

void Leaving::wish(const Losses& losses) {
  leaves_ = !losses.any();
  asks_ = !leaves_;
}

void Leaving::answer(const gui::Leave& answer, const Losses& losses, bool choosing) {
  once_saved_ = answer.saves && choosing;
  // What saving cannot end is asked about on its own.
  asks_ = answer.saves && !losses.unsaved && losses.unfinished;
  leaves_ = answer.really || (answer.saves && !losses.any());
}

void Leaving::chosen(const Losses& losses) {
  if (std::exchange(once_saved_, false) && !losses.unsaved) wish(losses);
}

void Leaving::look(const Losses& losses) {
  if (!losses.any()) asks_ = false;
}

}  // namespace aucast::app
