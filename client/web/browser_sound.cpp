#include "client/web/browser_sound.h"

#include "client/web/browser.h"

namespace aucast::web {

void BrowserSound::write(std::span<const float> samples) {
  browser::write_sound(samples);
  written_ += static_cast<std::int64_t>(samples.size());
}

std::int64_t BrowserSound::heard() {
  return written_ - static_cast<std::int64_t>(browser::unheard_samples());
}

}  // namespace aucast::web
