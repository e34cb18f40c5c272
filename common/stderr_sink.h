#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

#include <spdlog/sinks/base_sink.h>

namespace aucast {

/// Writes the log to a descriptor, usually stderr, and waits for no reader: a line that cannot be
/// written at once (a pipe nobody reads, a stopped terminal) is dropped and counted, and the count
/// is logged before the next line that can be written. The descriptor stays blocking, since other
/// programs may share it: if one of them fills the pipe between our look at it and our write, our
/// write waits. Thread: any; spdlog's lock is held while it writes.
class StderrSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  /// `colours`: whether the level is coloured.
  StderrSink(int descriptor, bool colours) : descriptor_(descriptor), colours_(colours) {}

  /// A pipe that is ready takes this much at once. Longer lines are cut.
  static constexpr std::size_t kLineBytesMax = PIPE_BUF;

 protected:
  void sink_it_(const spdlog::details::log_msg& entry) override;
  void flush_() override {}

 private:
  [[nodiscard]] std::string line_of(const spdlog::details::log_msg& entry);
  [[nodiscard]] bool write_now(std::string_view line) const;

  int descriptor_;
  bool colours_;
  std::uint64_t dropped_ = 0;
};

}  // namespace aucast
