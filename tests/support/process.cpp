#include "tests/support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <thread>

#include "common/check.h"

extern char** environ;

namespace aucast::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Appends what the pipe holds; closes it at the end of the output.
void drain(int& pipe, std::string& into) {
  std::array<char, 4096> chunk{};
  const ssize_t got = ::read(pipe, chunk.data(), chunk.size());
  if (got > 0) {
    into.append(chunk.data(), static_cast<std::size_t>(got));
  } else if (got == 0 || (errno != EINTR && errno != EAGAIN)) {
    ::close(pipe);
    pipe = -1;
  }
}

}  // namespace

Process::Process(std::vector<std::string> arguments, std::vector<std::string> variables) {
  AUCAST_CHECK(!arguments.empty());
  std::array<int, 2> out{};
  std::array<int, 2> err{};
  AUCAST_CHECK(::pipe2(out.data(), O_CLOEXEC) == 0);
  AUCAST_CHECK(::pipe2(err.data(), O_CLOEXEC) == 0);

  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view old = *entry;
    const auto name = old.substr(0, old.find('=') + 1);
    bool replaced = false;
    for (const std::string& variable : variables) replaced |= variable.starts_with(name);
    if (!replaced) environment.push_back(*entry);
  }
  environment.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, out[1], 1);
  ::posix_spawn_file_actions_adddup2(&actions, err[1], 2);
  // nohup, for one, ignores signals that tests send.
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  sigset_t usual;
  ::sigemptyset(&usual);
  for (const int one : {SIGHUP, SIGINT, SIGTERM}) ::sigaddset(&usual, one);
  ::posix_spawnattr_setsigdefault(&attributes, &usual);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  const int failed =
      ::posix_spawnp(&pid_, argv[0], &actions, &attributes, argv.data(), environment.data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(out[1]);
  ::close(err[1]);
  out_pipe_ = out[0];
  err_pipe_ = err[0];
  if (failed != 0) {
    pid_ = -1;
    exit_code_ = 127;
  }
}

Process::~Process() {
  if (!exit_code_.has_value() && pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  if (out_pipe_ >= 0) ::close(out_pipe_);
  if (err_pipe_ >= 0) ::close(err_pipe_);
}

void Process::pump(milliseconds patience) {
  std::array<pollfd, 2> pipes{{{out_pipe_, POLLIN, 0}, {err_pipe_, POLLIN, 0}}};
  if (::poll(pipes.data(), pipes.size(), static_cast<int>(patience.count())) <= 0) return;
  if (out_pipe_ >= 0 && pipes[0].revents != 0) drain(out_pipe_, out_);
  if (err_pipe_ >= 0 && pipes[1].revents != 0) drain(err_pipe_, err_);
}

std::optional<std::string> Process::read_line(milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  for (;;) {
    const std::size_t end = out_.find('\n', line_begin_);
    if (end != std::string::npos) {
      std::string line = out_.substr(line_begin_, end - line_begin_);
      line_begin_ = end + 1;
      return line;
    }
    const auto left = std::chrono::duration_cast<milliseconds>(until - steady_clock::now());
    if (left.count() <= 0 || out_pipe_ < 0) return std::nullopt;
    pump(left);
  }
}

void Process::signal(int number) const {
  if (pid_ > 0 && !exit_code_.has_value()) ::kill(pid_, number);
}

std::optional<int> Process::wait(milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  while (!exit_code_.has_value()) {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      break;
    }
    if (steady_clock::now() >= until) return std::nullopt;
    if (out_pipe_ >= 0 || err_pipe_ >= 0) {
      pump(milliseconds(5));
    } else {
      std::this_thread::sleep_for(milliseconds(1));
    }
  }
  // A grandchild may hold the pipes open: take what is there, do not wait for their end.
  for (int empty = 0; (out_pipe_ >= 0 || err_pipe_ >= 0) && empty < 2;) {
    const std::size_t before = out_.size() + err_.size();
    pump(milliseconds(20));
    empty = out_.size() + err_.size() == before ? empty + 1 : 0;
  }
  return exit_code_;
}

Finished run(std::vector<std::string> arguments, std::vector<std::string> variables,
             milliseconds patience) {
  Process process(std::move(arguments), std::move(variables));
  const auto code = process.wait(patience);
  return {code.value_or(-1), process.out(), process.err()};
}

std::string program(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace aucast::test
