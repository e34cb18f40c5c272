#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <spdlog/spdlog.h>

#include "common/result.h"

namespace aucast {

/// How an entry of the log looks.
enum class LogFormat : std::uint8_t {
  Text,  ///< time (UTC), level, program: message
  Json,  ///< one object a line: time, level, program, message
};

/// Sends the log to stderr, one line per entry, and never waits for whoever reads it (StderrSink).
/// The log is coloured on a terminal unless NO_COLOR is set. Where stderr is the journal (as
/// $JOURNAL_STREAM says and a check confirms), each line begins with its priority, <3> to <7>, and
/// a text line leaves out what the journal adds itself. Fails with a Usage error unless `level` is
/// one of trace, debug, info, warning, error, off. Text from outside must be escaped() before it is
/// logged; entries are made printable() in any case.
[[nodiscard]] Result<void> set_up_log(std::string_view program, std::string_view level,
                                      LogFormat format = LogFormat::Text);

/// Logs each line of `text`, with `before` before it.
void log_lines(spdlog::level::level_enum level, std::string_view before, const std::string& text);

/// Writes `text`, the reason why a program ends, to stderr. The text is no entry of the log, but if
/// stderr is the journal, each line begins with the priority of an error.
void print_error(std::string_view text);

}  // namespace aucast
