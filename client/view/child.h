#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/result.h"

namespace aucast::view {

/// A program that is fed through its standard input while its last words on stderr are kept. It
/// runs in a process group of its own, so that Ctrl-C in a terminal does not end it before it has
/// finished its file. Never raises SIGPIPE and leaves no zombie.
/// Thread: one at a time.
class Child {
 public:
  /// `arguments[0]` is looked up in $PATH. Failed with the system's reason when it cannot start;
  /// the caller is told by `missing` when there is no such program.
  [[nodiscard]] static Result<std::unique_ptr<Child>> start(
      const std::vector<std::string>& arguments, bool& missing);
  ~Child();  ///< kills what still runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Blocks until the child took all bytes; false when it reads no more.
  [[nodiscard]] bool feed(std::span<const std::uint8_t> bytes);
  /// Ends the input and waits for the end: the exit code, or 128 + the signal that killed it. The
  /// same again when called again.
  [[nodiscard]] int wait();
  /// The end of what it wrote to stderr, at most 2 KiB.
  [[nodiscard]] const std::string& last_words() const { return last_words_; }

 private:
  Child(pid_t pid, int input, int errors) : pid_(pid), input_(input), errors_(errors) {}
  bool read_errors();

  pid_t pid_;
  int input_;   ///< a socket: send() can be told not to raise SIGPIPE
  int errors_;  ///< -1 once its end was seen
  std::string last_words_;
  std::optional<int> exit_code_;
};

}  // namespace aucast::view
