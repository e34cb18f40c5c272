// A link with delay, jitter, losses and a rate between two network devices (TUN), for systems whose
// kernel has no netem. Makes the two devices, says "ready" and passes packets on until SIGTERM;
// SIGUSR1 takes the link down, SIGUSR2 up again. Who runs it moves the devices into network
// namespaces (scripts/faults.py does). Needs the right to make devices (CAP_NET_ADMIN).

#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <vector>

#include "common/command_line.h"
#include "tests/support/linkemu/link_queue.h"

namespace {

using aucast::Instant;
using aucast::linkemu::LinkQueue;
using aucast::linkemu::Quality;

Instant now() {
  return std::chrono::steady_clock::now();
}

struct Options {
  std::vector<std::string> devices;
  Quality quality;
  std::uint64_t seed = 1;
};

aucast::Result<Options> options_from(int argc, char** argv, bool& help) {
  Options options;
  CLI::App app("Makes two network devices with a bad link between them (needs root).", "linkemu");
  app.add_option("DEVICE", options.devices, "names of the two devices")->expected(2);
  app.add_option("--delay", options.quality.delay_ms, "ms in each direction (0)");
  app.add_option("--jitter", options.quality.jitter_ms, "up to so many ms more or less (0)");
  app.add_option("--loss", options.quality.loss_percent, "percent of packets (0)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--burst", options.quality.burst, "losses in a row, on the average (1)");
  app.add_option("--rate", options.quality.kilobits, "kbit/s in each direction (0: no limit)");
  app.add_option("--queue", options.quality.queue_bytes, "bytes that may wait (65536)");
  app.add_option("--seed", options.seed, "of jitter and losses (1)");
  auto parsed = aucast::parse_command_line(app, {argv + 1, argv + argc});
  help = app.get_help_ptr()->count() > 0;
  if (help) std::fputs(app.help().c_str(), stdout);
  if (!parsed && !help) return parsed.error();
  if (!help && options.devices.size() != 2) {
    return aucast::Error{aucast::ErrorKind::Usage, "two DEVICEs are needed (try --help)"};
  }
  return options;
}

/// A TUN device of that name; -1, with errno, when it cannot be made.
int make_device(const std::string& name) {
  const int device = ::open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (device < 0) return -1;
  ifreq request{};
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  name.copy(request.ifr_name, IFNAMSIZ - 1);
  if (::ioctl(device, TUNSETIFF, &request) == 0) return device;
  ::close(device);
  return -1;
}

int signals() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2}) ::sigaddset(&set, number);
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  return ::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
}

class Link {
 public:
  Link(std::array<int, 2> devices, const Options& options)
      : devices_(devices),
        ways_{LinkQueue(options.quality, options.seed), LinkQueue(options.quality, ~options.seed)} {
  }

  void run() {
    const int signal = signals();
    std::printf("ready\n");
    std::fflush(stdout);
    while (!over_) {
      std::array<pollfd, 3> polled{
          {{devices_[0], POLLIN, 0}, {devices_[1], POLLIN, 0}, {signal, POLLIN, 0}}};
      const timespec patience = until_next();
      ::ppoll(polled.data(), polled.size(), &patience, nullptr);
      if (polled[2].revents != 0) obey(signal);
      for (std::size_t way : {0U, 1U}) pass(way);
    }
    for (std::size_t way : {0U, 1U}) {
      std::printf("direction %zu: %llu passed, %llu lost, %llu in a row, %llu did not fit\n",
                  way + 1, static_cast<unsigned long long>(ways_[way].passed()),
                  static_cast<unsigned long long>(ways_[way].lost()),
                  static_cast<unsigned long long>(ways_[way].longest_loss()),
                  static_cast<unsigned long long>(ways_[way].too_many()));
    }
  }

 private:
  [[nodiscard]] timespec until_next() const {
    auto next = now() + std::chrono::seconds(1);
    for (const LinkQueue& way : ways_) next = std::min(next, way.next_at().value_or(next));
    const auto left = std::max<std::int64_t>(
        0, std::chrono::duration_cast<std::chrono::nanoseconds>(next - now()).count());
    return {left / 1'000'000'000, left % 1'000'000'000};
  }

  void obey(int signal) {
    signalfd_siginfo info{};
    while (::read(signal, &info, sizeof info) == sizeof info) {
      const auto number = static_cast<int>(info.ssi_signo);
      over_ = over_ || number == SIGTERM || number == SIGINT;
      for (LinkQueue& way : ways_) {
        if (number == SIGUSR1 || number == SIGUSR2) way.set_down(number == SIGUSR1);
      }
    }
  }

  /// From device `way` to the other.
  void pass(std::size_t way) {
    std::array<char, 65536> packet;
    for (ssize_t got = 0; (got = ::read(devices_[way], packet.data(), packet.size())) > 0;) {
      ways_[way].put(std::string(packet.data(), static_cast<std::size_t>(got)), now());
    }
    while (const auto arrived = ways_[way].take(now())) {
      // A device that is not up yet takes nothing: that packet is lost, as on any cut cable.
      static_cast<void>(::write(devices_[1 - way], arrived->data(), arrived->size()) < 0);
    }
  }

  std::array<int, 2> devices_;
  std::array<LinkQueue, 2> ways_;
  bool over_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  bool help = false;
  const auto options = options_from(argc, argv, help);
  if (help) return 0;
  if (!options) {
    std::fprintf(stderr, "linkemu: %s\n", options.error().message.c_str());
    return aucast::exit_code(options.error());
  }
  std::array<int, 2> devices{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string& name = options.value().devices[i];
    devices[i] = make_device(name);
    if (devices[i] >= 0) continue;
    std::fprintf(stderr, "linkemu: device %s cannot be made: %s\n", name.c_str(),
                 std::strerror(errno));
    return 1;
  }
  Link(devices, options.value()).run();
  return 0;
}
