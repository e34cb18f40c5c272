#include "client/net/connected_source.h"

namespace aucast::net {

std::optional<playback::Keyframe> ConnectedSource::take() {
  bool speaks = false;
  auto keyframe = reader_.with([&speaks](AuReader& reader) {
    auto taken = reader.take();
    speaks = reader.calls_for_speak();
    return taken;
  });
  if (speaks) speak();
  return keyframe;
}

std::optional<playback::Voice> ConnectedSource::take_voice() {
  return reader_.with([](AuReader& reader) { return reader.take_voice(); });
}

std::optional<playback::Caption> ConnectedSource::take_caption() {
  return reader_.with([](AuReader& reader) { return reader.take_caption(); });
}

bool ConnectedSource::ready() const {
  return reader_.with([](const AuReader& reader) { return reader.ready(); });
}

playback::SourceStatus ConnectedSource::status() const {
  return reader_.with([](const AuReader& reader) { return reader.status(); });
}

void ConnectedSource::stop() {
  reader_.with([](AuReader& reader) { reader.leave(); });
  leave();
}

void ConnectedSource::pause() {
  set_paused(true);
}

void ConnectedSource::resume() {
  set_paused(false);
}

void ConnectedSource::set_paused(bool paused) {
  reader_.with([paused](AuReader& reader) { reader.set_paused(paused); });
  speak();
}

}  // namespace aucast::net
