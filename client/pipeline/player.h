#pragma once

#include <functional>
#include <span>

#include "client/pipeline/face_pipeline.h"
#include "client/playback/playback.h"

namespace aucast::pipeline {

/// A face that is moved by a Playback. It has no clock: time is handed in. The mapping and what is
/// opened must outlive it. advance() allocates nothing.
/// Thread: the player's.
class Player {
 public:
  Player(const AuMapping& mapping, playback::Interpolation interpolation);

  /// Opens what plays from the next advance() on; the face stays as it is until the first keyframe.
  /// Null: nothing plays.
  void open(playback::Playback* playback);
  [[nodiscard]] playback::Playback* playback() const { return playback_; }

  /// Called for each keyframe that begins, once pipeline() has it.
  using OnBegin = std::function<void(const playback::KeyframeBegun&)>;
  /// Moves the face to `now`, and begins every keyframe that is due.
  void advance(Instant now, const OnBegin& on_begin = {});
  /// Call it when the mapping has changed: makes the keyframe under way anew.
  void remake();
  /// Call it when the mapping has a new face, which goes on with the same AUs.
  void change_face();
  /// Takes effect at once.
  void set_interpolation(playback::Interpolation kind);

  /// The face as of the last call that changed it.
  [[nodiscard]] const FaceState& face() const { return face_; }
  /// Sets the face, from which the next keyframe begins.
  void set_face(std::span<const float> activations);
  [[nodiscard]] const FacePipeline& pipeline() const { return pipeline_; }

 private:
  void begin(const playback::KeyframeBegun& begun);
  void move();

  playback::Playback* playback_ = nullptr;
  FacePipeline pipeline_;
  FaceState face_;
  bool begun_ = false;  ///< pipeline_ has a keyframe of playback_
};

}  // namespace aucast::pipeline
