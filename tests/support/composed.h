#pragma once

#include "client/gui/editing/composer.h"

namespace aucast::test {

/// Adds `count` keyframes to the timeline: AU 1, AU 2, AU 3 ..., each at 100 %.
inline void compose(gui::Composer& composer, int count) {
  for (int number = 1; number <= count; ++number) {
    composer.set_aus({}, false);
    composer.set_au(number, 100, 100, false);
    composer.add();
  }
}

}  // namespace aucast::test
