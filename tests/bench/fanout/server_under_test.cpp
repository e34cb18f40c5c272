#include "tests/bench/fanout/server_under_test.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/bench/fanout/message.h"
#include "tests/bench/fanout/processors.h"
#include "tests/support/served.h"

namespace aucast::bench {
namespace {

using namespace std::chrono_literals;

/// Time for all subscribers to come before the measuring.
constexpr int kGatheringSeconds = 60;

std::string redis_publish(const std::string& message) {
  return "*3\r\n$7\r\nPUBLISH\r\n$1\r\nc\r\n$" + std::to_string(message.size()) + "\r\n" + message +
         "\r\n";
}

/// MQTT 3.1.1, PUBLISH with QoS 0: type, length of the rest, topic, payload.
std::string mqtt_publish(const std::string& message) {
  return std::string("\x30") + static_cast<char>(3 + message.size()) + std::string("\0\1c", 3) +
         message;
}

constexpr const char* kRedisSubscribe = "*2\r\n$9\r\nSUBSCRIBE\r\n$1\r\nc\r\n";
constexpr std::size_t kRedisSubscribedBytes = 30;
/// CONNECT with a clean session, no keep-alive and an empty client name, which the server fills in.
const std::string kMqttConnect("\x10\x0c\0\4MQTT\4\2\0\0\0\0", 14);
constexpr std::size_t kMqttConnectedBytes = 4;
const std::string kMqttSubscribe("\x82\6\0\1\0\1c\0", 8);
constexpr std::size_t kMqttSubscribedBytes = 5;

std::string nats_publish(const std::string& message) {
  return "PUB c " + std::to_string(message.size()) + "\r\n" + message + "\r\n";
}

/// A port that was free a moment ago: not every server can be asked for any.
std::uint16_t free_port() {
  const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ::bind(probe, reinterpret_cast<sockaddr*>(&address), size);
  ::getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(probe);
  return ntohs(address.sin_port);
}

bool can_connect(std::uint16_t port) {
  const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  const bool heard = ::connect(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  ::close(probe);
  return heard;
}

}  // namespace

ServerUnderTest::ServerUnderTest(const std::string& name, const Plan& plan,
                                 const ServerUnderTest* parent) {
  // A child has the processors of who starts it.
  const OnProcessor placed(plan.server_processor);
  if (name == kOurs) {
    start_transmitter(plan, parent);
  } else if (name == "redis") {
    start_redis();
  } else if (name == "mosquitto") {
    start_mosquitto();
  } else if (name == "nats") {
    start_nats(parent);
  } else {
    failure_ = "'" + name + "' is no server this program knows: redis, mosquitto, nats";
  }
}

ServerUnderTest::~ServerUnderTest() {
  if (process_ == nullptr) return;
  process_->signal(SIGTERM);
  static_cast<void>(process_->wait(10s));
}

/// A stream is its own publisher: of a burst all but the last keyframe take no time. Empty, with
/// failure(), when it would be too long.
std::string ServerUnderTest::numbered_stream(const Plan& plan) {
  const std::int64_t bursts = (kGatheringSeconds + plan.seconds) * 1000LL / plan.period_ms() + 2;
  if (bursts * plan.burst > kNumbers) {
    failure_ = "so many messages cannot be told apart: choose a smaller rate, burst or time";
    return {};
  }
  std::string stream = "Beg_Stream\n";
  for (std::int64_t number = 0; number < bursts * plan.burst; ++number) {
    const bool last = (number + 1) % plan.burst == 0;
    std::string line = message(number, last ? plan.period_ms() : 0);
    stream += line.substr(1, line.size() - 2) + '\n';
  }
  return folder_.write("numbered.txt", stream + "End_Stream\n");
}

void ServerUnderTest::start_transmitter(const Plan& plan, const ServerUnderTest* parent) {
  std::vector<std::string> command = {test::program("au-transmitter"), "--port",
                                      std::to_string(plan.port), "--log-level", "error"};
  if (parent != nullptr) {
    if (plan.one_port) command.push_back("--reuse-port");
    command.push_back("aucast://127.0.0.1:" + std::to_string(parent->port()) + "/numbered");
  } else {
    command.insert(command.end(), {"--live", numbered_stream(plan)});
    if (!failure_.empty()) return;
  }
  if (plan.flood > 0) {
    http_port_ = free_port();
    command.insert(command.end(), {"--http", "127.0.0.1:" + std::to_string(http_port_)});
  }
  if (plan.web) command.insert(command.end(), {"--web", "127.0.0.1:0"});
  process_ = std::make_unique<test::Process>(std::move(command));
  auto line = process_->read_line(20s);
  if (line && plan.web) line = process_->read_line(20s);  // "web on" follows "listening on"
  if (!line) {
    failure_ = "au-transmitter did not start: " + process_->err();
    return;
  }
  port_ = static_cast<std::uint16_t>(std::stoi(line->substr(line->rfind(':') + 1)));
  dialect_.greeting = "{hello v=2 window=0}";
  dialect_.welcome_begin = "{hello ";
  dialect_.welcome_end = "}";
  dialect_.web = plan.web;
}

void ServerUnderTest::start_redis() {
  port_ = free_port();
  process_ = std::make_unique<test::Process>(std::vector<std::string>{
      "redis-server", "--port", std::to_string(port_), "--bind", "127.0.0.1", "--save", "",
      "--appendonly", "no", "--protected-mode", "no", "--maxclients", "19900",
      "--client-output-buffer-limit", "pubsub 0 0 0", "--logfile", folder_.path() / "log", "--dir",
      folder_.path()});
  dialect_.greeting = kRedisSubscribe;
  dialect_.welcome_bytes = kRedisSubscribedBytes;
  dialect_.wrap = &redis_publish;
  wait_until_it_listens();
}

void ServerUnderTest::start_mosquitto() {
  port_ = free_port();
  const std::string configuration =
      folder_.write("mosquitto.conf", "listener " + std::to_string(port_) +
                                          " 127.0.0.1\nallow_anonymous true\n"
                                          "set_tcp_nodelay true\npersistence false\n"
                                          "max_queued_messages 0\nlog_dest none\nuser root\n");
  process_ = std::make_unique<test::Process>(
      std::vector<std::string>{"mosquitto", "-c", configuration},
      std::vector<std::string>{"PATH=/usr/sbin:/usr/bin:/sbin:/bin"});
  dialect_.greeting = kMqttConnect + kMqttSubscribe;
  dialect_.welcome_bytes = kMqttConnectedBytes + kMqttSubscribedBytes;
  dialect_.announce = kMqttConnect;
  dialect_.announced_bytes = kMqttConnectedBytes;
  dialect_.wrap = &mqtt_publish;
  wait_until_it_listens();
}

void ServerUnderTest::start_nats(const ServerUnderTest* parent) {
  port_ = free_port();
  leaf_port_ = free_port();
  const std::string leaf_nodes =
      parent == nullptr
          ? "listen: 127.0.0.1:" + std::to_string(leaf_port_)
          : "remotes: [{url: \"nats-leaf://127.0.0.1:" + std::to_string(parent->leaf_port_) +
                "\"}]";
  const std::string configuration = folder_.write(
      "nats.conf", "listen: 127.0.0.1:" + std::to_string(port_) + "\nleafnodes { " + leaf_nodes +
                       " }\nlog_file: \"" + std::string(folder_.path() / "log") + "\"\n");
  process_ = std::make_unique<test::Process>(
      std::vector<std::string>{"nats-server", "-c", configuration},
      std::vector<std::string>{"PATH=/usr/sbin:/usr/bin:/sbin:/bin"});
  dialect_.greeting = "CONNECT {\"verbose\":true}\r\nSUB c 1\r\n";
  dialect_.welcome_begin = "INFO ";
  dialect_.welcome_end = "+OK\r\n+OK\r\n";
  dialect_.announce = "CONNECT {\"verbose\":false}\r\n";
  dialect_.wrap = &nats_publish;
  wait_until_it_listens();
}

void ServerUnderTest::wait_until_it_listens() {
  for (int attempt = 0; attempt < 200; ++attempt) {
    if (process_->wait(50ms)) break;
    if (can_connect(port_)) return;
  }
  failure_ =
      "it did not start (scripts/install_deps.sh scripts/packages_bench.txt installs them): " +
      process_->out() + process_->err();
}

std::chrono::nanoseconds ServerUnderTest::processor_time() const {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process_->pid(), &clock) != 0) return {};
  ::clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

long ServerUnderTest::private_bytes() const {
  std::ifstream file("/proc/" + std::to_string(process_->pid()) + "/smaps_rollup");
  long bytes = 0;
  for (std::string word; file >> word;) {
    if (word != "Private_Clean:" && word != "Private_Dirty:") continue;
    long kilobytes = 0;
    file >> kilobytes;
    bytes += kilobytes * 1024;
  }
  return bytes;
}

std::size_t ServerUnderTest::descriptors() const {
  std::error_code ignored;
  std::size_t count = 0;
  const std::string folder = "/proc/" + std::to_string(process_->pid()) + "/fd";
  for (std::filesystem::directory_iterator entry(folder, ignored), end; entry != end; ++entry) {
    ++count;
  }
  return count;
}

}  // namespace aucast::bench
