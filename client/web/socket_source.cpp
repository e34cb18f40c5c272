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
    : reader_(reader_options(server, std::move(stream), std::move(token), voice)),
      redial_([this] { dial(); }),
      connection_(reader_, std::move(server),
                  {[this](Milliseconds wait) { redial_.set(now() + wait); },
                   [this] { redial_.set(std::nullopt); }, [] {}}) {
  redial_.set(now());
}

void SocketSource::dial() {
  connection_.begin(SocketLink::create());
}

void SocketSource::speak() {
  connection_.speak(now());
}

std::optional<playback::TimedAus> SocketSource::take() {
  bool has_words = false;
  auto keyframe = reader_.with([&has_words](net::AuReader& reader) {
    auto taken = reader.take();
    has_words = reader.has_words();
    return taken;
  });
  if (has_words) speak();
  return keyframe;
}

std::optional<playback::Voice> SocketSource::take_voice() {
  return reader_.with([](net::AuReader& reader) { return reader.take_voice(); });
}

std::optional<playback::Caption> SocketSource::take_caption() {
  return reader_.with([](net::AuReader& reader) { return reader.take_caption(); });
}

bool SocketSource::ready() const {
  return reader_.with([](const net::AuReader& reader) { return reader.ready(); });
}

bool SocketSource::wait_until(Instant /*until*/) {
  return ready();
}

playback::SourceStatus SocketSource::status() const {
  auto status = reader_.with([](const net::AuReader& reader) { return reader.status(); });
  status.bytes_sent = connection_.bytes_sent();
  return status;
}

void SocketSource::stop() {
  reader_.with([](net::AuReader& reader) { reader.leave(); });
  redial_.set(std::nullopt);
  connection_.leave();
}

void SocketSource::pause() {
  reader_.with([](net::AuReader& reader) { reader.set_paused(true); });
  speak();
}

void SocketSource::resume() {
  reader_.with([](net::AuReader& reader) { reader.set_paused(false); });
  speak();
}

}  // namespace aucast::web
