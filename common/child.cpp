#include "common/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

#include "common/check.h"
#include "common/text.h"

namespace aucast {
namespace {

constexpr std::size_t kErrorBytesKept = 2048;  ///< kept; the last line may have all of it
constexpr std::size_t kErrorBytesShown = 300;
constexpr int kSendBufferBytes = 1 << 20;
constexpr int kSignal = 128;  ///< plus its number: the code of a child that a signal killed
/// How often a function that waits looks whether it is to wait on.
constexpr Milliseconds kLookEvery{50};
/// How long the pipes of a child that has ended may stay open.
constexpr Milliseconds kLeftOpenMax{500};

/// What is readable when the process has ended; -1: systems before Linux 5.3, some sandboxes and
/// browsers give none, and the process must be asked about.
int process_descriptor([[maybe_unused]] pid_t process) {
#ifdef SYS_pidfd_open
  return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
#else
  return -1;
#endif
}

// As those of posix_spawn, the functions below return the number of an error, or 0.

/// The child starts with no signal blocked and none ignored, whatever its parent does.
int set_attributes(posix_spawnattr_t& attributes) {
  sigset_t none;
  sigset_t defaults;
  sigemptyset(&none);
  sigfillset(&defaults);
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

/// Who starts us may have ignored SIGCHLD, which we inherit: the system would reap our children by
/// itself, and nobody could wait for them. A handler stays.
void let_children_be_waited_for() {
  struct sigaction present {};
  if (::sigaction(SIGCHLD, nullptr, &present) != 0 || present.sa_handler != SIG_IGN) return;
  std::signal(SIGCHLD, SIG_DFL);
}

Error cannot_start(const std::string& program, int error_number) {
  return {error_number == ENOENT ? ErrorKind::Unreadable : ErrorKind::Failed,
          program + " cannot be started: " + system_reason(error_number)};
}

}  // namespace

Result<std::unique_ptr<Child>> Child::start(const std::vector<std::string>& arguments, Flow flow,
                                            GivenUp given_up) {
  let_children_be_waited_for();
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
  return std::unique_ptr<Child>(
      new Child(pid, std::move(flow_end), std::move(error_end), std::move(given_up)));
}

Child::~Child() {
  stop();
  if (reaped()) return;
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Child::read_errors() {
  std::array<char, 4096> chunk{};
  const ssize_t got = ::read(errors_.get(), chunk.data(), chunk.size());
  if (got < 0 && errno == EINTR) return;
  if (got <= 0) {
    errors_ = Descriptor();
    return;
  }
  error_tail_.append(chunk.data(), static_cast<std::size_t>(got));
  if (error_tail_.size() > kErrorBytesKept) {
    error_tail_.erase(0, error_tail_.size() - kErrorBytesKept);
  }
}

/// False: nobody wants it any more, or what it has left behind keeps its pipes open; it is killed.
/// `idle`: nothing has come since this was asked last.
bool Child::goes_on(bool idle) {
  const Instant now = std::chrono::steady_clock::now();
  if (!idle || !has_ended()) {
    left_open_since_.reset();
  } else if (!left_open_since_) {
    left_open_since_ = now;
  }
  const bool left_open = left_open_since_ && now - *left_open_since_ >= kLeftOpenMax;
  if (!left_open && (!given_up_ || !given_up_())) return true;
  stop();
  return false;
}

/// Waits until the flow is ready and reads the child's errors meanwhile: a child that waits for
/// room on stderr would never go on. nullopt: waiting failed.
std::optional<bool> Child::poll_flow(short events, Milliseconds most) {
  std::array<pollfd, 2> waits{{{flow_.get(), events, 0}, {errors_.get(), POLLIN, 0}}};
  const int ready = ::poll(waits.data(), waits.size(), static_cast<int>(most.count()));
  if (ready < 0 && errno != EINTR) return std::nullopt;
  if (ready <= 0) return false;
  if (errors_.open() && waits[1].revents != 0) read_errors();
  return waits[0].revents != 0;
}

bool Child::feed(std::span<const std::uint8_t> bytes) {
  bool idle = false;
  while (!bytes.empty()) {
    if (!flow_.open() || !goes_on(idle)) return false;
    const auto ready = poll_flow(POLLOUT, kLookEvery);
    if (!ready) return false;
    idle = !*ready;
    if (idle) continue;
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
    // When waiting fails, reading says so.
    if (poll_flow(POLLIN, left).value_or(true)) return true;
  }
  return true;
}

std::size_t Child::read(std::span<std::uint8_t> bytes) {
  bool idle = false;
  while (flow_.open() && goes_on(idle)) {
    idle = !poll_flow(POLLIN, kLookEvery).value_or(true);
    if (idle) continue;
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

bool Child::reaped() const {
  return end_.with([](const End& end) { return end.code.has_value(); });
}

/// It may not be reaped yet.
bool Child::has_ended() const {
  if (reaped()) return true;
  siginfo_t ended{};
  const int failed = ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
  return failed == 0 && ended.si_pid == pid_;
}

bool Child::ends_within(Milliseconds patience) const {
  constexpr Milliseconds kAskEvery{5};
  const Descriptor process(process_descriptor(pid_));
  pollfd end{process.get(), POLLIN, 0};
  const auto until = std::chrono::steady_clock::now() + patience;
  while (!has_ended()) {
    const auto left = std::chrono::ceil<Milliseconds>(until - std::chrono::steady_clock::now());
    if (left <= Milliseconds::zero()) return false;
    const Milliseconds most = process.open() ? left : std::min(left, kAskEvery);
    ::poll(&end, 1, static_cast<int>(most.count()));
  }
  return true;
}

void Child::stop() {
  end_.with([this](End& end) {
    if (end.code) return;
    end.stopped = true;
    ::kill(-pid_, SIGKILL);
  });
}

bool Child::killed() const {
  return end_.with([](const End& end) { return end.stopped && end.code == kSignal + SIGKILL; });
}

int Child::wait(Milliseconds patience) {
  if (const auto code = end_.with([](const End& end) { return end.code; })) return *code;
  flow_ = Descriptor();
  const Instant begin = std::chrono::steady_clock::now();
  while ((errors_.open() || !has_ended()) && goes_on(true)) {
    if (std::chrono::floor<Milliseconds>(std::chrono::steady_clock::now() - begin) >= patience) {
      stop();
      break;
    }
    if (errors_.open()) {
      static_cast<void>(poll_flow(0, kLookEvery));
    } else {
      static_cast<void>(ends_within(kLookEvery));
    }
  }
  errors_ = Descriptor();
  siginfo_t ended{};
  while (::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOWAIT) < 0 &&
         errno == EINTR) {
  }
  return end_.with([this](End& end) {
    int status = 0;
    const pid_t waited = ::waitpid(pid_, &status, 0);
    AUCAST_CHECK(waited == pid_);
    end.code = WIFEXITED(status) ? WEXITSTATUS(status) : kSignal + WTERMSIG(status);
    return *end.code;
  });
}

std::string Child::error_tail() const {
  std::string words = error_tail_;
  while (!words.empty() && words.back() == '\n') words.pop_back();
  if (words.size() > kErrorBytesShown) words.erase(0, words.size() - kErrorBytesShown);
  std::replace(words.begin(), words.end(), '\n', ' ');
  return escaped(words, 4 * kErrorBytesShown);
}

std::string Child::last_line() const {
  std::string_view words = error_tail_;
  while (words.ends_with('\n')) words.remove_suffix(1);
  return printable(words.substr(words.rfind('\n') + 1));
}

}  // namespace aucast
