#include "client/sound/heard_player.h"

#include <cmath>

namespace aucast::sound {

void HeardPlayer::open(playback::Playback* playback, std::span<const float> from) {
  sound_.open(playback);
  delay_.clear();
  face_.set_face(from);
  face_.open(playback);
}

Instant HeardPlayer::advance(Instant steady, const OnBegin& on_begin) {
  const Instant at = sound_.now(steady);
  face_.advance(at, [&](const playback::KeyframeBegun& begun) { on_begin(begun, at); });
  sound_.advanced();
  if (sound_.sounds()) {
    delay_.forget_before(sound_.shown());  // nobody may look for long
    delay_.add(at, face_.face().activations);
  }
  return at;
}

const std::vector<float>& HeardPlayer::activations() {
  if (!sound_.sounds() || delay_.empty()) return face_.face().activations;
  return delay_.at(sound_.shown());
}

std::optional<Duration> HeardPlayer::heard_place() const {
  if (playback() == nullptr) return std::nullopt;
  const auto passing = playback()->passing();
  if (!passing) return std::nullopt;
  const double ahead = seconds(sound_.lead()) * passing->speed;
  return passing->place - Duration(std::llround(ahead * 1e9));
}

bool HeardPlayer::over() const {
  return playback() != nullptr && playback()->over() && !sound_.rings_on();
}

void HeardPlayer::change_face() {
  face_.change_face();
  delay_.clear();
}

}  // namespace aucast::sound
