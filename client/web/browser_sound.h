#pragma once

#include <cstdint>
#include <span>

#include "client/sound/sound_out.h"

namespace aucast::web {

/// The sound device of the browser (browser.h). It is in use while the page is allowed to play
/// sound.
/// Thread: the page's.
class BrowserSound final : public sound::SoundOut {
 public:
  void write(std::span<const float> samples) override;
  [[nodiscard]] std::int64_t heard() override;
  /// Always false: the page removes the device before it could be lost.
  [[nodiscard]] bool lost() override { return false; }

 private:
  std::int64_t written_ = 0;
};

}  // namespace aucast::web
