#pragma once

#include <string>

#include "client/gui/model/gui_model.h"
#include "client/gui/texts/said_text.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The last sentence that was said to the user. It disappears after a while. English messages from
/// other code are translated if possible.
class Notices {
 public:
  void say(const std::string& text, bool bad, Instant now) {
    notice_ = {gui::in_used_language(text), bad};
    until_ = now + (bad ? kBadTime : kTime);
  }
  /// Says what became of something; an empty sentence is not said.
  void tell(const Result<std::string>& outcome, Instant now) {
    if (!outcome) return say(outcome.error().message, true, now);
    if (!outcome->empty()) say(*outcome, false, now);
  }
  void clear() { notice_ = {}; }
  /// Removes the sentence if it has been shown long enough.
  void expire(Instant now) {
    if (now >= until_) clear();
  }
  [[nodiscard]] const gui::Notice& view() const { return notice_; }
  /// When the sentence disappears. Only meaningful while there is a sentence.
  [[nodiscard]] Instant until() const { return until_; }

 private:
  static constexpr Milliseconds kTime{6'000};
  static constexpr Milliseconds kBadTime{20'000};

  gui::Notice notice_;
  Instant until_{};
};

}  // namespace aucast::app
