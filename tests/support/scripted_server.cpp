#include "tests/support/scripted_server.h"

#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

#include "common/check.h"
#include "common/text.h"
#include "tests/support/loopback.h"

namespace aucast::test {
namespace {

constexpr int kStepPatienceMs = 20'000;

}  // namespace

ScriptedServer::ScriptedServer(std::vector<Step> steps) {
  AUCAST_CHECK(::pipe2(quit_, O_CLOEXEC) == 0);
  const LoopbackSocket listener = listen_on_loopback();
  listener_ = listener.descriptor;
  port_ = listener.port;
  thread_ = std::jthread([this, script = std::move(steps)] { play(script); });
}

ScriptedServer::~ScriptedServer() {
  ::close(quit_[1]);
  if (thread_.joinable()) thread_.join();
  close_client();
  ::close(listener_);
  ::close(quit_[0]);
}

std::string ScriptedServer::finish() {
  if (thread_.joinable()) thread_.join();
  return failure_;
}

std::string ScriptedServer::received() const {
  const std::lock_guard lock(mutex_);
  return received_;
}

void ScriptedServer::play(const std::vector<Step>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string failure =
        std::visit([this](const auto& step) { return play_step(step); }, steps[i]);
    if (failure.empty()) continue;
    failure_ = "step " + std::to_string(i) + ": " + failure;
    return;
  }
}

std::string ScriptedServer::play_step(const Accept& /*step*/) {
  close_client();
  if (!wait_for(listener_, POLLIN)) return "nobody connected";
  client_ = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (client_ < 0) return "could not accept";
  const int on = 1;
  ::setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return {};
}

std::string ScriptedServer::play_step(const Expect& step) {
  std::string got;
  char byte = 0;
  while (got.size() < step.bytes.size() && read_byte(byte)) got += byte;
  if (got == step.bytes) return {};
  return "expected '" + escaped(step.bytes) + "', got '" + escaped(got) + "'";
}

std::string ScriptedServer::play_step(const ExpectHello& /*step*/) {
  std::string got;
  char byte = 0;
  while (!got.ends_with('}') && read_byte(byte)) got += byte;
  if (got.starts_with("{hello") && got.ends_with('}')) return {};
  return "expected a hello, got '" + escaped(got) + "'";
}

std::string ScriptedServer::play_step(const ExpectEnd& /*step*/) {
  char byte = 0;
  while (read_byte(byte)) {
  }
  // A wait that was broken off or ran out of time is not the client's end.
  if (!wait_for(client_, POLLIN)) return "the client did not end";
  return {};
}

std::string ScriptedServer::play_step(const Send& step) {
  const std::size_t portion = step.portion == 0 ? step.bytes.size() : step.portion;
  for (std::size_t at = 0; at < step.bytes.size();) {
    if (!wait_for(client_, POLLOUT)) return {};
    const std::size_t size = std::min(portion, step.bytes.size() - at);
    const ssize_t sent = ::send(client_, step.bytes.data() + at, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno != EAGAIN && errno != EINTR) return {};
    if (sent > 0) at += static_cast<std::size_t>(sent);
  }
  return {};
}

std::string ScriptedServer::play_step(const Until& step) {
  const auto patience = std::chrono::milliseconds(kStepPatienceMs);
  const bool ready = step.ready.wait_for(patience) == std::future_status::ready;
  return ready ? "" : "the test was never ready";
}

std::string ScriptedServer::play_step(const HalfClose& /*step*/) {
  ::shutdown(client_, SHUT_WR);
  return {};
}

std::string ScriptedServer::play_step(const Close& /*step*/) {
  close_client();
  return {};
}

std::string ScriptedServer::play_step(const Reset& /*step*/) {
  const linger hard{1, 0};
  ::setsockopt(client_, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
  close_client();
  return {};
}

bool ScriptedServer::wait_for(int descriptor, short what) const {
  std::array<pollfd, 2> waits{{{descriptor, what, 0}, {quit_[0], POLLIN, 0}}};
  int ready = 0;
  do {
    ready = ::poll(waits.data(), waits.size(), kStepPatienceMs);
  } while (ready < 0 && errno == EINTR);
  return ready > 0 && waits[0].revents != 0 && waits[1].revents == 0;
}

bool ScriptedServer::read_byte(char& byte) {
  if (!wait_for(client_, POLLIN) || ::recv(client_, &byte, 1, 0) != 1) return false;
  const std::lock_guard lock(mutex_);
  received_ += byte;
  return true;
}

void ScriptedServer::close_client() {
  if (client_ >= 0) ::close(client_);
  client_ = -1;
}

}  // namespace aucast::test
