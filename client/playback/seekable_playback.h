#pragma once

#include <memory>
#include <vector>

#include "client/playback/keyframe_list.h"
#include "client/playback/local_playback.h"
#include "client/playback/playback.h"

namespace aucast::playback {

/// Plays a stream that is available whole. The face at a position does not depend on how the
/// position was reached.
/// Thread: none of its own.
class SeekablePlayback final : public Playback {
 public:
  /// `keyframes`: at least one; those without a time of their own take `untimed`. It plays from the
  /// first advance() on, unless it was paused or sought before.
  SeekablePlayback(KeyframeList keyframes, Milliseconds untimed);

  [[nodiscard]] std::optional<KeyframeBegun> advance(Instant now) override;
  void pause(Instant now) override;
  /// At the end, plays from the beginning.
  void resume(Instant now) override;
  void stop(Instant now) override;
  [[nodiscard]] PlaybackState state() const override;
  [[nodiscard]] PlaybackProgress progress() const override;
  [[nodiscard]] std::optional<Instant> next_position_at() const override;
  [[nodiscard]] std::optional<Passing> passing() const override;
  [[nodiscard]] std::uint64_t keyframes_played() const override;
  [[nodiscard]] Duration media_time() const override;
  [[nodiscard]] SourceStatus status() const override;
  [[nodiscard]] SeekablePlayback* seekable() override { return this; }

  /// The position, for seeking, steps, speed and loop. If nothing was played, paused or sought
  /// before, playing begins.
  [[nodiscard]] LocalPlayback& playhead(Instant now);
  [[nodiscard]] const LocalPlayback& playhead() const { return playhead_; }
  /// As of the last advance().
  [[nodiscard]] Duration position() const { return position_; }
  [[nodiscard]] const KeyframeList& keyframes() const { return keyframes_; }
  /// The time of those without one of their own.
  [[nodiscard]] Milliseconds untimed() const { return untimed_; }
  /// When each keyframe is reached, ascending.
  [[nodiscard]] const std::shared_ptr<const std::vector<Duration>>& ends() const { return ends_; }
  /// The keyframe under way, for a caller that must begin it once more, from the face before it,
  /// because the mapping has changed.
  [[nodiscard]] KeyframeBegun under_way() const;

 private:
  KeyframeList keyframes_;
  LocalPlayback playhead_;
  std::shared_ptr<const std::vector<Duration>> ends_;
  Milliseconds untimed_;
  StreamPlace place_;
  Duration position_{0};
  Instant looked_at_{};
  bool begun_ = false;
  bool untouched_ = true;  ///< neither played, paused nor sought yet
  bool ended_ = false;
  bool stopped_ = false;
};

}  // namespace aucast::playback
