#pragma once

#include <string>

#include "client/app/steady.h"

namespace aucast::app {

/// Shows on standard error the progress of a long run: on a terminal as one line that is
/// overwritten, elsewhere as a plain line every few seconds, so that a log stays short.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows `text()` if it is time for it. `last`: no more texts follow; a terminal then shows this
  /// one even if it is not time for it yet.
  template <typename Text>
  void show(const Text& text, bool last = false) {
    if (is_due(last)) write(text());
  }

  /// Ends the line, so that something else can be written; show() then begins a new one.
  void interrupt();
  /// Ends the line and writes `text` on a new line below it.
  void end_with(const std::string& text);

 private:
  [[nodiscard]] bool is_due(bool last);
  void write(const std::string& text);

  bool wanted_;
  bool terminal_;
  bool shown_ = false;  ///< the terminal's line has a text
  std::size_t length_ = 0;
  Instant last_ = steady_now();
};

}  // namespace aucast::app
