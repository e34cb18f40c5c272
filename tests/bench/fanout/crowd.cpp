#include "tests/bench/fanout/crowd.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <thread>

#include "tests/bench/fanout/message.h"

namespace aucast::bench {

int connect_to(std::uint16_t port, int number) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return -1;
  const int on = 1;
  // The system chooses the port when it knows the other end too, which is quick.
  ::setsockopt(socket, IPPROTO_IP, IP_BIND_ADDRESS_NO_PORT, &on, sizeof on);
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  sockaddr_in from{};
  from.sin_family = AF_INET;
  from.sin_addr.s_addr = htonl(INADDR_LOOPBACK + static_cast<unsigned>(number % 8));
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to.sin_port = htons(port);
  if (::bind(socket, reinterpret_cast<sockaddr*>(&from), sizeof from) != 0 ||
      ::connect(socket, reinterpret_cast<sockaddr*>(&to), sizeof to) != 0) {
    ::close(socket);
    return -1;
  }
  ::fcntl(socket, F_SETFL, O_NONBLOCK);
  return socket;
}

namespace {

/// The subscribers look for what has come so often, instead of waiting for it: waking somebody is
/// work of the system that the sender's processor does, once for almost every message, and real
/// subscribers sleep on machines of their own.
constexpr std::chrono::microseconds kLook{200};

/// The time of day at which the system got the bytes is told with them from now on.
void tell_arrivals(int socket) {
  const int on = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
}

/// All of it: so little always has room.
bool say(int socket, std::string_view bytes) {
  return ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
         static_cast<ssize_t>(bytes.size());
}

}  // namespace

Crowd::Crowd(const Dialect& dialect)
    : dialect_(dialect), epoll_(::epoll_create1(EPOLL_CLOEXEC)), input_(65536) {}

Crowd::~Crowd() {
  for (const Subscriber& subscriber : subscribers_) {
    if (subscriber.socket >= 0) ::close(subscriber.socket);
  }
  ::close(epoll_);
}

bool Crowd::join(int count, std::uint16_t port) {
  const std::string first = dialect_.web ? WebSide::upgrade() : dialect_.greeting;
  for (int joined = 0; joined < count; ++joined) {
    const auto index = subscribers_.size();
    const int socket = connect_to(port, static_cast<int>(index));
    if (socket < 0 || !say(socket, first)) {
      failure_ = "subscriber " + std::to_string(index) + ": " + std::strerror(errno);
      return false;
    }
    tell_arrivals(socket);
    Subscriber subscriber;
    subscriber.index = index;
    subscriber.socket = socket;
    subscribers_.push_back(std::move(subscriber));
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = index;
    ::epoll_ctl(epoll_, EPOLL_CTL_ADD, socket, &event);
    // The server is given time to accept: the queue of the port is not endless.
    if (joined % 100 == 99) listen(Clock::now() + std::chrono::milliseconds(2), nullptr);
  }
  return true;
}

void Crowd::listen(Clock::time_point until, std::vector<Delivery>* deliveries) {
  real_ahead_ =
      std::chrono::system_clock::now().time_since_epoch() - Clock::now().time_since_epoch();
  std::array<epoll_event, 512> events{};
  while (Clock::now() < until) {
    const int count = ::epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), 0);
    for (int i = 0; i < count; ++i) {
      receive(subscribers_[events[static_cast<std::size_t>(i)].data.u64], deliveries);
    }
    if (count < static_cast<int>(events.size())) std::this_thread::sleep_for(kLook);
  }
}

bool Crowd::wait_for_welcome(Clock::duration patience) {
  const auto until = Clock::now() + patience;
  while (welcomed_ < static_cast<int>(subscribers_.size()) && Clock::now() < until) {
    listen(Clock::now() + std::chrono::milliseconds(20), nullptr);
  }
  return welcomed_ == static_cast<int>(subscribers_.size()) && disturbed_ == 0;
}

void Crowd::receive(Subscriber& subscriber, std::vector<Delivery>* deliveries) {
  if (subscriber.socket < 0) return;
  Clock::time_point arrived;
  const ssize_t got = read(subscriber.socket, arrived);
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (got <= 0) {
    disturb(subscriber, got == 0 ? "the connection ended" : std::strerror(errno));
    return;
  }
  const auto now = Clock::now();
  std::string_view bytes(input_.data(), static_cast<std::size_t>(got));
  std::string text;
  if (dialect_.web) {
    if (!take_frames(subscriber, bytes, text)) return;
    bytes = text;
  }
  std::string joined;
  if (!subscriber.held.empty()) {
    joined = subscriber.held + std::string(bytes);
    subscriber.held.clear();
    bytes = joined;
  }
  if (!subscriber.welcomed) bytes.remove_prefix(take_welcome(subscriber, bytes));
  // Neither redis nor MQTT has a brace around the messages of this program.
  while (subscriber.welcomed) {
    const std::size_t begin = bytes.find('{');
    const std::size_t end = bytes.find('}', begin == std::string_view::npos ? 0 : begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) break;
    const std::string_view inside = bytes.substr(begin + 1, end - begin - 1);
    if (inside == "-2") {
      disturb(subscriber, "the stream ended");
      return;
    }
    const std::int64_t number = number_in(inside);
    take_message(subscriber, number);
    if (deliveries != nullptr) deliveries->push_back({subscriber.index, number, arrived, now});
    bytes.remove_prefix(end + 1);
  }
  subscriber.held = bytes;
}

/// What a WebSocket brings; false when it has ended.
bool Crowd::take_frames(Subscriber& subscriber, std::string_view wire, std::string& text) {
  std::string answer;
  const bool good = subscriber.web.received(wire, dialect_.greeting, text, answer) &&
                    (answer.empty() || say(subscriber.socket, answer));
  if (!good) disturb(subscriber, "the WebSocket ended: " + std::string(wire.substr(0, 60)));
  return good;
}

/// As recv(), with the time at which the last of the bytes arrived.
ssize_t Crowd::read(int socket, Clock::time_point& arrived) {
  iovec bytes{input_.data(), input_.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec))> control{};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t got = ::recvmsg(socket, &message, 0);
  arrived = Clock::now();
  const cmsghdr* told = got > 0 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (told != nullptr && told->cmsg_type == SCM_TIMESTAMPNS) {
    timespec time{};
    std::memcpy(&time, CMSG_DATA(told), sizeof time);
    arrived = Clock::time_point(std::chrono::seconds(time.tv_sec) +
                                std::chrono::nanoseconds(time.tv_nsec) - real_ahead_);
  }
  return got;
}

/// How many bytes of the answer to the greeting are over.
std::size_t Crowd::take_welcome(Subscriber& subscriber, std::string_view bytes) {
  std::size_t size = dialect_.welcome_bytes;
  if (size == 0) {
    const std::size_t end = bytes.find(dialect_.welcome_end);
    if (end == std::string_view::npos) return 0;
    size = end + dialect_.welcome_end.size();
  }
  if (bytes.size() < size) return 0;
  subscriber.welcomed = true;
  ++welcomed_;
  if (dialect_.welcome_bytes == 0 && !bytes.starts_with(dialect_.welcome_begin)) {
    disturb(subscriber, "the hello was answered by " + std::string(bytes.substr(0, size)));
  }
  return size;
}

void Crowd::take_message(Subscriber& subscriber, std::int64_t number) {
  if (number < 0) {
    disturb(subscriber, "got something that is no message");
    return;
  }
  if (subscriber.expected >= 0 && number != subscriber.expected) {
    missed_ += std::max<std::int64_t>(number - subscriber.expected, 1);
  }
  subscriber.expected = number + 1;
}

void Crowd::disturb(Subscriber& subscriber, const std::string& how) {
  ++disturbed_;
  failure_ = how;
  ::close(subscriber.socket);
  subscriber.socket = -1;
}

}  // namespace aucast::bench
