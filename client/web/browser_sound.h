#pragma once

#include <cstdint>
#include <span>

#include "client/sound/sound_out.h"

namespace aucast::web {

/// The sound device of the browser, while the page is allowed to play sound: browser.h. Thread: the
/// page's.
class BrowserSound final : public sound::SoundOut {
 public:
  void write(std::span<const float> samples) override;
  [[nodiscard]] std::int64_t heard() override;
  /// The page takes the device away before that can be.
  [[nodiscard]] bool lost() override { return false; }

 private:
  std::int64_t written_ = 0;
};

}  // namespace aucast::web
