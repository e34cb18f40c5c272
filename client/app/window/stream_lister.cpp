#include "client/app/window/stream_lister.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "common/text.h"

namespace aucast::app {

StreamLister::StreamLister(Ask ask) : ask_(std::move(ask)) {}

void StreamLister::ask(net::RemoteOptions server) {
  server.connect_timeout = std::min<Duration>(server.connect_timeout, kTimeMax);
  view_ = {.asking = true, .names = {}, .problem = {}};
  next_ = std::move(server);
  if (!answer_.valid()) begin();
}

void StreamLister::begin() {
  const net::RemoteOptions server = *std::exchange(next_, std::nullopt);
  try {
    answer_ = std::async(std::launch::async, ask_, server);
  } catch (const std::system_error& failure) {
    view_ = {.asking = false, .names = {}, .problem = shortage_text(failure)};
  }
}

void StreamLister::advance() {
  using std::chrono::seconds;
  if (!answer_.valid() || answer_.wait_for(seconds(0)) != std::future_status::ready) return;
  auto answer = answer_.get();
  if (next_) return begin();
  view_ = {};
  if (answer) {
    view_.names = *std::move(answer);
  } else {
    view_.problem = answer.error().message;
  }
}

}  // namespace aucast::app
