#pragma once

#include <cstddef>
#include <optional>

#include "client/playback/keyframe_list.h"
#include "client/playback/keyframe_source.h"

namespace aucast::playback {

/// A stream file, played without a server. It is always ready, so nothing ever stalls. Its status
/// says from the start that the stream has ended, because nothing more will arrive. After stop() it
/// gives no keyframes.
/// Thread: the player's.
class FileSource final : public KeyframeSource {
 public:
  /// `untimed`: the time of keyframes without one of their own; the keyframes then have places.
  explicit FileSource(KeyframeList keyframes, std::optional<Milliseconds> untimed = std::nullopt);

  [[nodiscard]] std::optional<Keyframe> take() override;
  [[nodiscard]] bool ready() const override;
  bool wait_until(Instant until) override;
  [[nodiscard]] SourceStatus status() const override;
  void stop() override;

 private:
  KeyframeList keyframes_;
  std::optional<Milliseconds> untimed_;
  std::size_t next_ = 0;
  Milliseconds place_{0};  ///< where the last one that was taken is reached
  bool stopped_ = false;
};

}  // namespace aucast::playback
