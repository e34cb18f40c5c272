#pragma once

#include <functional>
#include <span>

#include "client/pipeline/face_pipeline.h"
#include "client/playback/playback.h"

namespace aucast::pipeline {

/// A face that is moved by a Playback, of either kind. It owns no clock: time is handed in.
/// The mapping and what is opened must outlive it. advance() allocates nothing.
/// Thread: the player's.
class Player {
 public:
  Player(const AuMapping& mapping, playback::Interpolation interpolation);

  /// Opens what plays from the next advance() on; until its first keyframe the face stays as it is.
  /// Null: nothing plays.
  void open(playback::Playback* playback);
  [[nodiscard]] playback::Playback* playback() const { return playback_; }

  /// Called for each keyframe that begins, when the pipeline has it.
  using OnBegin = std::function<void(const playback::KeyframeBegun&)>;
  /// Moves to `now`: begins one keyframe after the other until none begins.
  void advance(Instant now, const OnBegin& on_begin = {});
  /// The mapping has changed: the keyframe under way is made anew.
  void remake();
  /// The mapping has a new face, which goes on with the same AUs.
  void change_face();
  /// Takes effect at once.
  void set_interpolation(playback::Interpolation kind);

  /// As of the last call that changed it.
  [[nodiscard]] const FaceState& face() const { return face_; }
  /// Sets the face: the next keyframe begins from there.
  void set_face(std::span<const float> activations);
  [[nodiscard]] const FacePipeline& pipeline() const { return pipeline_; }

 private:
  void begin(const playback::KeyframeBegun& begun);
  void move();

  playback::Playback* playback_ = nullptr;
  FacePipeline pipeline_;
  FaceState face_;
  bool begun_ = false;  ///< the pipeline has a keyframe of what is open
};

}  // namespace aucast::pipeline
