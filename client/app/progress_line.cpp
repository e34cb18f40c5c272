#include "client/app/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace aucast::app {

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  interrupt();
}

void ProgressLine::interrupt() {
  if (shown_) std::fputc('\n', stderr);
  shown_ = false;
  length_ = 0;
}

bool ProgressLine::is_due(bool last) {
  if (!wanted_) return false;
  const Instant now = steady_now();
  const auto pause = terminal_ ? Milliseconds(200) : Milliseconds(5000);
  if (now - last_ < pause && !(terminal_ && (last || !shown_))) return false;
  last_ = now;
  return true;
}

void ProgressLine::write(const std::string& text) {
  if (!terminal_) {
    std::fprintf(stderr, "%s\n", text.c_str());
    return;
  }
  // Blanks overwrite the rest of a longer text.
  const std::string padding(length_ > text.size() ? length_ - text.size() : 0, ' ');
  std::fprintf(stderr, "\r%s%s", text.c_str(), padding.c_str());
  length_ = text.size();
  shown_ = true;
}

void ProgressLine::end_with(const std::string& text) {
  if (!wanted_) return;
  interrupt();
  std::fprintf(stderr, "%s\n", text.c_str());
}

}  // namespace aucast::app
