#pragma once

#include <string>

#include "client/gui/gui_model.h"
#include "client/gui/said_text.h"
#include "common/time.h"

namespace aucast::app {

/// One sentence for the user, which goes away by itself: the last one that was said, in the
/// language in use where it is one of those that come up in English.
class Notices {
 public:
  void say(const std::string& text, bool bad, Instant now) {
    notice_ = {gui::in_used_language(text), bad};
    until_ = now + (bad ? kBadTime : kTime);
  }
  void clear() { notice_ = {}; }
  /// Forgets what was said long enough ago.
  void expire(Instant now) {
    if (now >= until_) clear();
  }
  [[nodiscard]] const gui::Notice& view() const { return notice_; }
  /// When it goes away; only while there is one.
  [[nodiscard]] Instant until() const { return until_; }

 private:
  static constexpr Milliseconds kTime{6'000};
  static constexpr Milliseconds kBadTime{20'000};

  gui::Notice notice_;
  Instant until_{};
};

}  // namespace aucast::app
