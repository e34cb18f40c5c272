#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/time.h"

namespace aucast {

/// A program that is fed through its standard input, or read from its standard output, or both,
/// while the end of what it writes to stderr is kept. It runs in a process group of its own, so
/// that Ctrl-C in a terminal does not end it before it has finished its file. Never raises SIGPIPE
/// and leaves no zombie. Thread: one at a time, but for stop(), tell() and end_input().
class Child {
 public:
  enum class Flow : std::uint8_t { Fed, Read, Both };

  /// `arguments[0]` is looked up in $PATH. Failed with the system's reason when it cannot start;
  /// `missing` tells the caller when there is no such program. A stream that is not piped is
  /// /dev/null.
  [[nodiscard]] static Result<std::unique_ptr<Child>> start(
      const std::vector<std::string>& arguments, bool& missing, Flow flow = Flow::Fed);
  ~Child();  ///< kills what still runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Blocks until the child took all bytes; false when it reads no more.
  [[nodiscard]] bool feed(std::span<const std::uint8_t> bytes);
  /// Whether it writes something, or ends, before `patience` is over; reads nothing.
  [[nodiscard]] bool await(Milliseconds patience);
  /// Waits for what it writes next and reads it; returns the number of bytes, 0 at the end.
  [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
  /// Sends a few bytes to a child that is both fed and read, without waiting; false when it does
  /// not take all. From any thread, before wait() or destruction.
  [[nodiscard]] bool tell(std::string_view bytes) const;
  /// Ends the input of such a child. From any thread, likewise.
  void end_input() const;
  /// Kills it. From any thread, before wait() or destruction: read() finds the end.
  void stop() const;
  /// Closes the pipes and waits for the end: returns the exit code, or 128 + the signal that killed
  /// it; the same when called again.
  [[nodiscard]] int wait();
  /// The end of what it wrote to stderr, at most 300 bytes of it, in one line, safe to print.
  [[nodiscard]] std::string last_words() const;
  /// The last line of that.
  [[nodiscard]] std::string last_line() const;

 private:
  Child(pid_t pid, int flow, int errors) : pid_(pid), flow_(flow), errors_(errors) {}
  [[nodiscard]] bool await_flow(int milliseconds);
  bool read_errors();

  pid_t pid_;
  int flow_;    ///< a socket: send() can be told not to raise SIGPIPE
  int errors_;  ///< -1 once its end was seen
  std::string last_words_;
  std::optional<int> exit_code_;
};

}  // namespace aucast
