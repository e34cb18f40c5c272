#include "common/log.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <spdlog/details/os.h>

#include "common/stderr_sink.h"
#include "common/text.h"

namespace aucast {
namespace {

/// systemd.exec(5): the descriptor's device and inode, to be compared, since children inherit the
/// variable even when their stderr goes elsewhere.
bool stderr_is_the_journal() {
  const char* stream = std::getenv("JOURNAL_STREAM");
  struct stat status {};
  if (stream == nullptr || ::fstat(STDERR_FILENO, &status) != 0) return false;
  return stream == std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
}

/// As in syslog(3).
char priority(spdlog::level::level_enum level) {
  switch (level) {
    case spdlog::level::critical:
      return '2';
    case spdlog::level::err:
      return '3';
    case spdlog::level::warn:
      return '4';
    case spdlog::level::info:
      return '6';
    default:
      return '7';
  }
}

std::string utc(spdlog::log_clock::time_point time) {
  const auto ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const auto seconds = static_cast<std::time_t>(ms / 1000);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 40> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &parts);
  std::snprintf(text.data() + length, text.size() - length, ".%03dZ", static_cast<int>(ms % 1000));
  return text.data();
}

/// The inside of a JSON string. Bytes above ASCII may be cut or no UTF-8 at all, so that they too
/// are written as the text \xNN. `room`: bytes that it may have; an escape is whole or left out.
std::string json_text(std::string_view message, std::size_t room) {
  std::string text;
  for (const char byte : message) {
    const auto code = static_cast<unsigned char>(byte);
    const bool is_told = byte == '"' || byte == '\\';
    const bool is_plain = code >= 0x20 && code < 0x7f;
    const std::string itself(1, byte);
    const std::string written =
        is_told ? "\\" + itself : (is_plain ? itself : "\\" + escaped(itself));
    if (text.size() + written.size() > room) break;
    text += written;
  }
  return text;
}

class LineFormatter : public spdlog::formatter {
 public:
  LineFormatter(std::string program, LogFormat format, bool journal)
      : program_(std::move(program)), format_(format), journal_(journal) {}

  void format(const spdlog::details::log_msg& entry, spdlog::memory_buf_t& out) override {
    const auto add = [&out](std::string_view text) {
      out.append(text.data(), text.data() + text.size());
    };
    const auto name = spdlog::level::to_string_view(entry.level);
    const std::string_view level(name.data(), name.size());
    const std::string_view message(entry.payload.data(), entry.payload.size());
    if (journal_) add({std::array{'<', priority(entry.level), '>'}.data(), 3});
    if (format_ == LogFormat::Json) {
      constexpr std::string_view kEnd = "\"}\n";
      add("{\"time\":\"" + utc(entry.time) + "\",\"level\":\"" + std::string(level) +
          "\",\"program\":\"" + program_ + "\",\"message\":\"");
      add(json_text(message, StderrSink::kLineBytesMax - out.size() - kEnd.size()));
      add(kEnd);
      return;
    }
    if (!journal_) {
      add(utc(entry.time) + " ");
      entry.color_range_start = out.size();
      add(level);
      entry.color_range_end = out.size();
      add(" " + program_ + ": ");
    }
    add(printable(message.substr(0, StderrSink::kLineBytesMax)) + "\n");
  }

  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<LineFormatter>(program_, format_, journal_);
  }

 private:
  std::string program_;
  LogFormat format_;
  bool journal_;
};

}  // namespace

Result<void> set_up_log(std::string_view program, std::string_view level, LogFormat format) {
  const auto parsed = spdlog::level::from_str(std::string(level));
  if (parsed == spdlog::level::off && level != "off") {
    return Error{ErrorKind::Usage, "--log-level '" + std::string(level) +
                                       "' is not one of trace, debug, info, warning, error, off"};
  }
  const bool colours = std::getenv("NO_COLOR") == nullptr && format == LogFormat::Text &&
                       spdlog::details::os::in_terminal(stderr) &&
                       spdlog::details::os::is_color_terminal();
  auto logger = std::make_shared<spdlog::logger>(
      std::string(program), std::make_shared<StderrSink>(STDERR_FILENO, colours));
  logger->set_level(parsed);
  logger->set_formatter(
      std::make_unique<LineFormatter>(std::string(program), format, stderr_is_the_journal()));
  spdlog::set_default_logger(std::move(logger));
  return {};
}

void log_lines(spdlog::level::level_enum level, std::string_view before, const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) spdlog::log(level, "{}{}", before, line);
}

void print_error(std::string_view text) {
  const std::array<char, 4> prefix{'<', priority(spdlog::level::err), '>', '\0'};
  const char* before = stderr_is_the_journal() ? prefix.data() : "";
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::fprintf(stderr, "%s%s\n", before, printable(line).c_str());
  }
}

}  // namespace aucast
