#pragma once

#include "client/gui/editing/composer.h"

namespace aucast::test {

/// Adds keyframes of AU 1, 2, 3 ... at 100 % to a timeline.
inline void compose(gui::Composer& composer, int count) {
  for (int number = 1; number <= count; ++number) {
    composer.set_aus({}, false);
    composer.set_au(number, 100, 100, false);
    composer.add();
  }
}

}  // namespace aucast::test
