#include "client/web/socket_source.h"

#include <utility>

#include "client/web/socket_link.h"

namespace aucast::web {
namespace {

net::AuReaderOptions reader_options(std::string server, std::string stream, std::string token,
                                    bool voice) {
  net::AuReaderOptions options;
  options.peer = std::move(server);
  options.stream = std::move(stream);
  options.token = std::move(token);
  options.voice = voice;
  options.captions = true;
  options.reconnect = true;
  options.buffers.by_time = true;
  options.buffers.adapt = true;
  return options;
}

}  // namespace

SocketSource::SocketSource(std::string server, std::string stream, std::string token, bool voice)
    : ConnectedSource(reader_options(server, std::move(stream), std::move(token), voice)),
      redial_([this] { dial(); }),
      connection_(reader(), std::move(server),
                  {[this](Milliseconds wait) { redial_.set(now() + wait); }},
                  {[this] { redial_.set(std::nullopt); }, [] {}}) {
  redial_.set(now());
}

void SocketSource::dial() {
  connection_.begin(SocketLink::create());
}

bool SocketSource::wait_until(Instant /*until*/) {
  return ready();
}

void SocketSource::speak() {
  connection_.speak(now());
}

void SocketSource::leave() {
  redial_.set(std::nullopt);
  connection_.leave();
}

}  // namespace aucast::web
