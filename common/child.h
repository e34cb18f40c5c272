#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/descriptor.h"
#include "common/result.h"
#include "common/shared.h"
#include "common/stopped.h"
#include "common/time.h"

namespace aucast {

/// A program that is fed through its standard input, or read from its standard output, or both. The
/// end of what it writes to stderr is kept. It runs in a process group of its own, so that Ctrl-C
/// in a terminal does not end it before it has finished its file. What it has started itself and
/// left behind with our pipes open is killed soon after its end. Never raises SIGPIPE and
/// leaves no zombie; where SIGCHLD is ignored, start() sets it to its default. Thread: one at a
/// time, except for stop(), tell() and end_input().
class Child {
 public:
  enum class Flow : std::uint8_t { Fed, Read, Both };

  /// `arguments[0]` is looked up in $PATH. Fails with Unreadable if there is no such program, with
  /// ErrorKind::Failed and the system's reason if it cannot start. Standard input or output that
  /// `flow` does not pipe is /dev/null. Once `given_up` returns true, the child is killed: feed()
  /// returns false, read() 0, and wait() waits no longer.
  [[nodiscard]] static Result<std::unique_ptr<Child>> start(
      const std::vector<std::string>& arguments, Flow flow = Flow::Fed, GivenUp given_up = {});
  ~Child();  ///< kills the child, and what it has started, if it still runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Blocks until the child has taken all bytes. Returns false when it reads no more.
  [[nodiscard]] bool feed(std::span<const std::uint8_t> bytes);
  /// Waits at most `patience` until the child writes or ends; reads nothing. Returns false if the
  /// child did neither.
  [[nodiscard]] bool await(Milliseconds patience);
  /// Waits for the child's next output and reads as much of it as fits. Returns the number of
  /// bytes; 0 at the end.
  [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
  /// Sends a few bytes to a child that is both fed and read, without waiting. Returns false if the
  /// child does not take all of them. From any thread, before wait() or destruction.
  [[nodiscard]] bool tell(std::string_view bytes) const;
  /// Ends the standard input of a child that is both fed and read. From any thread, before wait()
  /// or destruction.
  void end_input() const;
  /// Waits at most `patience` for the end of the child, which may come a little after that of its
  /// output. False: it still runs.
  [[nodiscard]] bool ends_within(Milliseconds patience) const;
  /// Kills it and what it has started, so that read() finds the end. From any thread, before
  /// destruction.
  void stop();
  /// Closes the pipes, waits for the child to end, and kills it after `patience`. Returns its exit
  /// code, or 128 + the signal that killed it; a further call returns the same.
  [[nodiscard]] int wait(Milliseconds patience = Milliseconds::max());
  /// After wait(): whether the child was killed from here, as it was given up or stopped, or since
  /// it did not end within the patience.
  [[nodiscard]] bool killed() const;
  /// The last 300 bytes that the child wrote to stderr, or fewer, joined into one line and safe to
  /// print.
  [[nodiscard]] std::string error_tail() const;
  /// The last line that the child wrote to stderr, of at most 2048 bytes. Only what is not safe to
  /// print is escaped, so that callers can recognise its words and users can read file names.
  [[nodiscard]] std::string last_line() const;

 private:
  Child(pid_t pid, Descriptor flow, Descriptor errors, GivenUp given_up)
      : pid_(pid),
        flow_(std::move(flow)),
        errors_(std::move(errors)),
        given_up_(std::move(given_up)) {}
  [[nodiscard]] std::optional<bool> poll_flow(short events, Milliseconds most);
  [[nodiscard]] bool goes_on(bool idle);
  [[nodiscard]] bool reaped() const;
  [[nodiscard]] bool has_ended() const;
  void read_errors();

  pid_t pid_;
  Descriptor flow_;    ///< a socket: send() can be told not to raise SIGPIPE
  Descriptor errors_;  ///< closed once its end was seen
  std::string error_tail_;
  GivenUp given_up_;
  std::optional<Instant> left_open_since_;  ///< the child has ended, and its pipes are open
  struct End {
    /// Set when the child is reaped: from then on its number may be that of another process.
    std::optional<int> code;
    bool stopped = false;
  };
  Shared<End> end_;
};

}  // namespace aucast
