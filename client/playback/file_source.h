#pragma once

#include <cstddef>
#include <vector>

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

/// Gives each keyframe its place; those without a time of their own take `untimed`.
void set_places(std::vector<Keyframe>& keyframes, Milliseconds untimed);

/// A stream file, played without a server. It is always ready, so nothing ever stalls. Its status
/// says from the start that the stream has ended, because nothing more will arrive. After stop() it
/// gives no keyframes.
/// Thread: the player's.
class FileSource final : public KeyframeSource {
 public:
  explicit FileSource(std::vector<Keyframe> keyframes);

  [[nodiscard]] std::optional<Keyframe> take() override;
  [[nodiscard]] bool ready() const override;
  bool wait_until(Instant until) override;
  [[nodiscard]] SourceStatus status() const override;
  void stop() override;

 private:
  std::vector<Keyframe> keyframes_;
  std::size_t next_ = 0;
  bool stopped_ = false;
};

}  // namespace aucast::playback
