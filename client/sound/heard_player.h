#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "client/pipeline/face_delay.h"
#include "client/pipeline/player.h"
#include "client/playback/playback.h"
#include "client/sound/sound_player.h"
#include "common/time.h"

namespace aucast::sound {

/// A face that plays with its sound. The player of the face is advanced by the SoundPlayer's clock,
/// which is ahead of what is heard; activations() are those of the face that belongs to what is
/// heard now. Without sound both faces are the same. The mapping and what is opened must outlive
/// it.
/// Thread: the player's.
class HeardPlayer {
 public:
  HeardPlayer(const pipeline::AuMapping& mapping, playback::Interpolation interpolation)
      : face_(mapping, interpolation) {}

  /// Opens what plays from the next advance() on; the face begins from the activations `from`. If
  /// `playback` is null, nothing plays and the face stays at `from`.
  void open(playback::Playback* playback, std::span<const float> from);
  [[nodiscard]] playback::Playback* playback() const { return face_.playback(); }

  /// The time to give playback when it is paused or sought at `steady`.
  [[nodiscard]] Instant now(Instant steady) { return sound_.now(steady); }
  /// Called for each keyframe that begins, with the time that now() gave: its sound may be heard
  /// later.
  using OnBegin = std::function<void(const playback::KeyframeBegun&, Instant at)>;
  /// Moves face and sound to `steady`; returns what now() gave for it.
  Instant advance(Instant steady, const OnBegin& on_begin);

  /// The face that belongs to what is heard. Valid until the next call.
  [[nodiscard]] const std::vector<float>& activations();
  /// The place in the stream that is being heard; nullopt if playback does not know its place.
  [[nodiscard]] std::optional<Duration> heard_place() const;
  /// Whether what was opened has come to its end, and its sound too; false if nothing is open.
  [[nodiscard]] bool over() const;
  /// Call it when the mapping has a new face.
  void change_face();

  /// The face as playback has it, ahead of what is heard.
  [[nodiscard]] pipeline::Player& face() { return face_; }
  [[nodiscard]] const pipeline::Player& face() const { return face_; }
  [[nodiscard]] SoundPlayer& sound() { return sound_; }
  [[nodiscard]] const SoundPlayer& sound() const { return sound_; }

 private:
  pipeline::Player face_;
  SoundPlayer sound_{nullptr};
  pipeline::FaceDelay delay_;
};

}  // namespace aucast::sound
