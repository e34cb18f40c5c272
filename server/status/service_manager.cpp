#include "server/status/service_manager.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>

#include "common/number_of.h"

namespace aucast::server {
namespace {

constexpr int kFirstPassed = 3;

/// How long a busy manager is waited for with what it must not miss.
constexpr timeval kSayTimeMax{1, 0};

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// STATUS= is one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// The time on CLOCK_MONOTONIC, as systemd wants it.
std::string monotonic_usec() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::to_string(std::int64_t{time.tv_sec} * 1'000'000 + time.tv_nsec / 1000);
}

/// Whether the variable is meant for this process, and was not just inherited.
bool is_ours(const std::string& pid) {
  return pid.empty() || number_of<std::int64_t>(pid) == std::int64_t{::getpid()};
}

bool is_listening_tcp(int descriptor) {
  int listening = 0;
  int type = 0;
  sockaddr_storage address{};
  socklen_t length = sizeof(listening);
  if (::getsockopt(descriptor, SOL_SOCKET, SO_ACCEPTCONN, &listening, &length) != 0) return false;
  length = sizeof(type);
  if (::getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &length) != 0) return false;
  length = sizeof(address);
  // The call wants the general type for every family.
  auto* general = reinterpret_cast<sockaddr*>(&address);
  if (::getsockname(descriptor, general, &length) != 0) return false;
  return listening != 0 && type == SOCK_STREAM &&
         (address.ss_family == AF_INET || address.ss_family == AF_INET6);
}

}  // namespace

ServiceManager::ServiceManager() : address_(variable("NOTIFY_SOCKET")) {
  const bool usable = (address_.starts_with('/') || address_.starts_with('@')) &&
                      address_.size() < sizeof(sockaddr_un::sun_path);
  if (usable) socket_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (socket_.open()) {
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_SNDTIMEO, &kSayTimeMax, sizeof(kSayTimeMax));
  }
  const auto usec = number_of<std::int64_t>(variable("WATCHDOG_USEC"));
  if (socket_.open() && usec && *usec > 0 && is_ours(variable("WATCHDOG_PID"))) {
    watchdog_ = std::chrono::microseconds(*usec);
  }
}

void ServiceManager::ready(const std::string& status) const {
  say("READY=1\nSTATUS=" + one_line(status), Need::Must);
}

void ServiceManager::reloading() const {
  say("RELOADING=1\nMONOTONIC_USEC=" + monotonic_usec(), Need::Must);
}

void ServiceManager::stopping(Milliseconds at_most) const {
  std::string message = "STOPPING=1";
  if (at_most.count() > 0) {
    const auto time = std::chrono::microseconds(at_most).count();
    message += "\nEXTEND_TIMEOUT_USEC=" + std::to_string(time);
  }
  say(message, Need::Must);
}

void ServiceManager::status(const std::string& status) const {
  say("STATUS=" + one_line(status), Need::May);
}

void ServiceManager::alive() const {
  say("WATCHDOG=1", Need::May);
}

void ServiceManager::say(std::string_view message, Need need) const {
  if (!socket_.open()) return;
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  std::copy(address_.begin(), address_.end(), to.sun_path);
  if (to.sun_path[0] == '@') to.sun_path[0] = '\0';  // an abstract address
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address_.size());
  // Nobody to tell when this fails; a manager that needs it notices by itself.
  static_cast<void>(::sendto(socket_.get(), message.data(), message.size(),
                             need == Need::May ? MSG_NOSIGNAL | MSG_DONTWAIT : MSG_NOSIGNAL,
                             reinterpret_cast<const sockaddr*>(&to), length));
}

Result<std::optional<int>> passed_socket() {
  const std::string pid = variable("LISTEN_PID");
  const auto count = number_of<std::int64_t>(variable("LISTEN_FDS"));
  if (pid.empty() || !is_ours(pid) || !count || *count < 1) return std::optional<int>();
  if (*count > 1) {
    return Error{ErrorKind::Usage, std::to_string(*count) +
                                       " sockets were passed (LISTEN_FDS); only one can be served"};
  }
  if (!is_listening_tcp(kFirstPassed)) {
    return Error{ErrorKind::Usage,
                 "what was passed (LISTEN_FDS) is not a listening TCP socket; use ListenStream= "
                 "with a port"};
  }
  ::fcntl(kFirstPassed, F_SETFD, FD_CLOEXEC);
  return std::optional<int>(kFirstPassed);
}

}  // namespace aucast::server
