#include "common/stderr_sink.h"

#include <poll.h>
#include <unistd.h>

namespace aucast {
namespace {

/// The colour of a level on a terminal.
std::string_view colour_of(spdlog::level::level_enum level) {
  switch (level) {
    case spdlog::level::trace:
      return "\033[37m";
    case spdlog::level::debug:
      return "\033[36m";
    case spdlog::level::info:
      return "\033[32m";
    case spdlog::level::warn:
      return "\033[33m\033[1m";
    default:
      return "\033[31m\033[1m";
  }
}

}  // namespace

void StderrSink::sink_it_(const spdlog::details::log_msg& entry) {
  if (dropped_ > 0) {
    const std::string said =
        std::to_string(dropped_) + " lines of the log were dropped here: nobody read them";
    if (!write_now(line_of({entry.time, {}, entry.logger_name, spdlog::level::warn, said}))) {
      ++dropped_;
      return;
    }
    dropped_ = 0;
  }
  if (!write_now(line_of(entry))) ++dropped_;
}

std::string StderrSink::line_of(const spdlog::details::log_msg& entry) {
  spdlog::memory_buf_t text;
  formatter_->format(entry, text);
  std::string line(text.data(), text.size());
  if (colours_ && entry.color_range_end > entry.color_range_start) {
    line.insert(entry.color_range_end, "\033[m");
    line.insert(entry.color_range_start, colour_of(entry.level));
  }
  if (line.size() > kLineBytesMax) line.replace(kLineBytesMax - 1, std::string::npos, "\n");
  return line;
}

bool StderrSink::write_now(std::string_view line) const {
  pollfd ready{descriptor_, POLLOUT, 0};
  if (::poll(&ready, 1, 0) != 1 || (ready.revents & POLLOUT) == 0) return false;
  return ::write(descriptor_, line.data(), line.size()) >= 0;
}

}  // namespace aucast
