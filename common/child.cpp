#include "common/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "common/check.h"
#include "common/text.h"

namespace aucast {
namespace {

constexpr std::size_t kLastWordsBytesMax = 2048;  ///< kept; the last line may have all of it
constexpr std::size_t kLastWordsShown = 300;
constexpr int kSendBufferBytes = 1 << 20;

// As those of posix_spawn, the functions below return the number of an error, or 0.

/// The child starts with no signal blocked and none ignored, whatever its parent does.
int set_attributes(posix_spawnattr_t& attributes) {
  sigset_t none;
  sigset_t defaults;
  sigemptyset(&none);
  sigemptyset(&defaults);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP}) sigaddset(&defaults, number);
  int error = ::posix_spawnattr_setsigmask(&attributes, &none);
  if (error == 0) error = ::posix_spawnattr_setsigdefault(&attributes, &defaults);
  if (error == 0) error = ::posix_spawnattr_setpgroup(&attributes, 0);
  if (error == 0) {
    error = ::posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  return error;
}

int connect(posix_spawn_file_actions_t& actions, Child::Flow flow, int theirs, int errors) {
  const auto join = [&](int descriptor, Child::Flow without, int mode) {
    return flow == without
               ? ::posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", mode, 0)
               : ::posix_spawn_file_actions_adddup2(&actions, theirs, descriptor);
  };
  int error = join(STDIN_FILENO, Child::Flow::Read, O_RDONLY);
  if (error == 0) error = join(STDOUT_FILENO, Child::Flow::Fed, O_WRONLY);
  if (error == 0) error = ::posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  return error;
}

int spawn(const std::vector<std::string>& arguments, Child::Flow flow, int theirs, int errors,
          pid_t& pid) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawnattr_t attributes;
  if (const int error = ::posix_spawnattr_init(&attributes); error != 0) return error;
  posix_spawn_file_actions_t actions;
  int error = ::posix_spawn_file_actions_init(&actions);
  if (error == 0) {
    error = set_attributes(attributes);
    if (error == 0) error = connect(actions, flow, theirs, errors);
    if (error == 0) {
      error = ::posix_spawnp(&pid, argv[0], &actions, &attributes, argv.data(), environ);
    }
    ::posix_spawn_file_actions_destroy(&actions);
  }
  ::posix_spawnattr_destroy(&attributes);
  return error;
}

Error cannot_start(const std::string& program, int error_number) {
  return {error_number == ENOENT ? ErrorKind::Unreadable : ErrorKind::Failed,
          program + " cannot be started: " + system_reason(error_number)};
}

}  // namespace

Result<std::unique_ptr<Child>> Child::start(const std::vector<std::string>& arguments, Flow flow) {
  std::array<int, 2> ends{-1, -1};  // ours, theirs
  std::array<int, 2> errors{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return cannot_start(arguments[0], errno);
  }
  Descriptor flow_end(ends[0]);
  const Descriptor theirs(ends[1]);
  if (::pipe2(errors.data(), O_CLOEXEC) != 0) return cannot_start(arguments[0], errno);
  Descriptor error_end(errors[0]);
  const Descriptor their_errors(errors[1]);
  ::setsockopt(flow_end.get(), SOL_SOCKET, SO_SNDBUF, &kSendBufferBytes, sizeof(kSendBufferBytes));
  pid_t pid = -1;
  const int failed = spawn(arguments, flow, theirs.get(), their_errors.get(), pid);
  if (failed != 0) return cannot_start(arguments[0], failed);
  return std::unique_ptr<Child>(new Child(pid, std::move(flow_end), std::move(error_end)));
}

Child::~Child() {
  if (!exit_code_.has_value()) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

bool Child::read_errors() {
  std::array<char, 4096> chunk{};
  const ssize_t got = ::read(errors_.get(), chunk.data(), chunk.size());
  if (got < 0 && errno == EINTR) return true;
  if (got <= 0) {
    errors_ = Descriptor();
    return false;
  }
  last_words_.append(chunk.data(), static_cast<std::size_t>(got));
  if (last_words_.size() > kLastWordsBytesMax) {
    last_words_.erase(0, last_words_.size() - kLastWordsBytesMax);
  }
  return true;
}

bool Child::feed(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    if (!flow_.open()) return false;
    // Its errors are read meanwhile: a child that waits for room on stderr would never read on.
    std::array<pollfd, 2> waits{{{flow_.get(), POLLOUT, 0}, {errors_.get(), POLLIN, 0}}};
    if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) return false;
    if (errors_.open() && waits[1].revents != 0) read_errors();
    if (waits[0].revents == 0) continue;
    const ssize_t sent =
        ::send(flow_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno != EINTR && errno != EAGAIN) {
      return false;
    }
  }
  return true;
}

bool Child::await(Milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (flow_.open()) {
    const auto left = std::chrono::ceil<Milliseconds>(until - std::chrono::steady_clock::now());
    if (left <= Milliseconds::zero()) return false;
    if (await_flow(static_cast<int>(left.count()))) return true;
  }
  return true;
}

/// Waits for output and reads the child's errors meanwhile. True: there is output, or waiting
/// failed.
bool Child::await_flow(int milliseconds) {
  std::array<pollfd, 2> waits{{{flow_.get(), POLLIN, 0}, {errors_.get(), POLLIN, 0}}};
  const int ready = ::poll(waits.data(), waits.size(), milliseconds);
  if (ready < 0) return errno != EINTR;
  if (errors_.open() && waits[1].revents != 0) read_errors();
  return waits[0].revents != 0;
}

std::size_t Child::read(std::span<std::uint8_t> bytes) {
  while (flow_.open()) {
    if (!await_flow(-1)) continue;
    const ssize_t got = ::recv(flow_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (got > 0) return static_cast<std::size_t>(got);
    if (got == 0 || (errno != EINTR && errno != EAGAIN)) return 0;
  }
  return 0;
}

bool Child::tell(std::string_view bytes) const {
  const ssize_t sent = ::send(flow_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  return sent == static_cast<ssize_t>(bytes.size());
}

void Child::end_input() const {
  ::shutdown(flow_.get(), SHUT_WR);
}

bool Child::ends_within(Milliseconds patience) const {
  constexpr Milliseconds kLookEvery{5};
  const auto until = std::chrono::steady_clock::now() + patience;
  while (!exit_code_.has_value()) {
    siginfo_t ended{};
    const int failed =
        ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (failed == 0 && ended.si_pid == pid_) return true;
    if (std::chrono::steady_clock::now() >= until) return false;
    std::this_thread::sleep_for(kLookEvery);
  }
  return true;
}

void Child::stop() const {
  ::kill(pid_, SIGKILL);
}

int Child::wait() {
  if (exit_code_.has_value()) return *exit_code_;
  flow_ = Descriptor();
  while (errors_.open() && read_errors()) {
  }
  int status = 0;
  pid_t waited = -1;
  do {
    waited = ::waitpid(pid_, &status, 0);
  } while (waited < 0 && errno == EINTR);
  AUCAST_CHECK(waited == pid_);
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return *exit_code_;
}

std::string Child::last_words() const {
  std::string words = last_words_;
  while (!words.empty() && words.back() == '\n') words.pop_back();
  if (words.size() > kLastWordsShown) words.erase(0, words.size() - kLastWordsShown);
  std::replace(words.begin(), words.end(), '\n', ' ');
  return escaped(words, 4 * kLastWordsShown);
}

std::string Child::last_line() const {
  std::string_view words = last_words_;
  while (words.ends_with('\n')) words.remove_suffix(1);
  return printable(words.substr(words.rfind('\n') + 1));
}

}  // namespace aucast
