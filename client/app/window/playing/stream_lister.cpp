#include "client/app/window/playing/stream_lister.h"

#include <utility>

namespace aucast::app {

StreamLister::StreamLister(Ask ask) : ask_(std::move(ask)) {}

void StreamLister::ask(net::RemoteOptions server) {
  view_ = {.asking = true, .streams = {}, .problem = {}};
  next_ = std::move(server);
  if (!asking_.running()) begin();
}

void StreamLister::begin() {
  const auto begun = asking_.start(
      [ask = ask_, server = *std::exchange(next_, std::nullopt)] { return ask(server, kTimeMax); });
  if (!begun) view_ = {.asking = false, .streams = {}, .problem = begun.error().message};
}

void StreamLister::advance() {
  auto answer = asking_.take();
  if (!answer) return;
  if (next_) return begin();
  view_ = {};
  if (*answer) {
    view_.streams = (*answer)->streams;
  } else {
    view_.problem = answer->error().message;
  }
}

}  // namespace aucast::app
