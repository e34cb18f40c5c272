#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aucast::test {

/// A program, ours or another, as a child process whose output is kept.
class Process {
 public:
  /// Starts `arguments[0]` with the given arguments; variables are added to the environment as
  /// NAME=VALUE.
  explicit Process(std::vector<std::string> arguments, std::vector<std::string> variables = {});
  ~Process();  ///< kills what is still running
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits for a whole line of stdout; nullopt when no line comes in time or the output ends.
  [[nodiscard]] std::optional<std::string> read_line(std::chrono::milliseconds patience);
  void signal(int number) const;
  /// The exit code (128 + signal when killed by one); nullopt when the program does not end in
  /// time.
  [[nodiscard]] std::optional<int> wait(std::chrono::milliseconds patience);
  /// Everything written so far; complete after wait().
  [[nodiscard]] const std::string& out() const { return out_; }
  [[nodiscard]] const std::string& err() const { return err_; }
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  void pump(std::chrono::milliseconds patience);

  pid_t pid_ = -1;
  int out_pipe_ = -1;
  int err_pipe_ = -1;
  std::string out_;
  std::string err_;
  std::size_t line_begin_ = 0;
  std::optional<int> exit_code_;
};

/// What a finished run left behind.
struct Finished {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a program to its end, for at most `patience`; after that the program is killed and
/// exit_code is -1.
[[nodiscard]] Finished run(std::vector<std::string> arguments,
                           std::vector<std::string> variables = {},
                           std::chrono::milliseconds patience = std::chrono::seconds(60));

/// A program beside this test program, such as face-player.
[[nodiscard]] std::string program(const std::string& name);

}  // namespace aucast::test
