#pragma once

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/result.h"
#include "common/text.h"
#include "common/waits.h"

namespace aucast::server {

/// The error for a system call on the input at `path` that has just failed.
[[nodiscard]] inline Error unreadable_now(const std::filesystem::path& path,
                                          int error_number = errno) {
  return {ErrorKind::Unreadable,
          at_place(path.string(), "cannot be read: " + system_reason(error_number))};
}

/// Reads an open descriptor, which it owns, on the event loop: a PipeReader or a FileReader.
/// Thread: that of the loop.
class InputReader {
 public:
  /// Any of these callbacks may stop the reader, for now or for good; on_end may destroy it.
  struct Events {
    std::function<void(std::string_view)> on_bytes;
    std::function<void(Error)> on_failure;  ///< a read failed
    std::function<void()> on_end;           ///< nothing more comes from this descriptor
    std::function<void()> on_caught_up;     ///< a growing file was read to its present end
    std::function<void(const std::string& why)> on_anew;  ///< the file is read from its start again
  };

  /// `events` must outlive it.
  InputReader(std::filesystem::path path, const Events& events)
      : path_(std::move(path)), events_(events), chunk_(kChunkBytes) {}
  virtual ~InputReader() = default;
  InputReader(const InputReader&) = delete;
  InputReader& operator=(const InputReader&) = delete;

  /// Begins to read.
  virtual void start() = 0;
  /// With false, stops reading for now; with true, goes on.
  void set_reading(bool reading) {
    if (!std::exchange(reading_, reading) && reading) await();
  }
  /// Reads no more, and calls no more callbacks.
  virtual void stop() = 0;
  /// Whether the input may hold bytes from before it was opened, as a file does and a pipe does
  /// not.
  [[nodiscard]] virtual bool has_past() const = 0;

 protected:
  /// Waits until there is something to read, unless that has begun or nothing is to be read.
  void await() {
    if (reading_ && !stopped_ && !std::exchange(waiting_, true)) wait_for_bytes();
  }

  const std::filesystem::path path_;
  const Events& events_;
  std::vector<char> chunk_;
  bool reading_ = true;
  bool stopped_ = false;  ///< by stop(), or since the input has ended
  bool waiting_ = false;
  Waits waits_;

 private:
  /// Reads when there is something, and sets waiting_ to false before.
  virtual void wait_for_bytes() = 0;

  static constexpr std::size_t kChunkBytes = 16384;
};

}  // namespace aucast::server
