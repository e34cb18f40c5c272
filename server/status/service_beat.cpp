#include "server/status/service_beat.h"

#include <algorithm>

namespace aucast::server {

void ServiceBeat::begin() {
  manager_.ready(summary_());
  if (manager_.present()) beat();
}

void ServiceBeat::beat() {
  if (manager_.watchdog()) manager_.alive();
  manager_.status(summary_());
  Duration pause = kStatusEvery;
  if (const auto watchdog = manager_.watchdog()) pause = std::min(pause, *watchdog / 2);
  timer_.after(pause, [this] { beat(); });
}

}  // namespace aucast::server
