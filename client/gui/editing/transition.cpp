#include "client/gui/editing/transition.h"

#include <algorithm>
#include <utility>

#include "client/playback/interpolator.h"

namespace aucast::gui {

Transition::Transition(std::vector<float> start, std::vector<float> end,
                       TransitionSettings settings, Instant begin)
    : start_(std::move(start)), end_(std::move(end)), settings_(settings), begin_(begin) {
  settings_.frames = std::max(settings_.frames, 1);
  settings_.frame_ms = std::max(settings_.frame_ms, 1);
}

int Transition::frame_at(Instant now) const {
  if (now <= begin_) return 0;
  const auto frame = (now - begin_) / Milliseconds(settings_.frame_ms);
  return static_cast<int>(std::min<Duration::rep>(frame, settings_.frames));
}

std::vector<float> Transition::at(Instant now) const {
  const auto kind =
      settings_.cosine ? playback::Interpolation::Cosine : playback::Interpolation::Linear;
  const double mu = static_cast<double>(frame_at(now)) / settings_.frames;
  std::vector<float> between(start_.size());
  playback::interpolate(start_, end_, playback::ease(kind, mu), between);
  return between;
}

bool Transition::over(Instant now) const {
  return frame_at(now) == settings_.frames;
}

std::optional<Instant> Transition::next_frame_at(Instant now) const {
  const int frame = frame_at(now);
  if (frame == settings_.frames) return std::nullopt;
  return begin_ + Milliseconds(settings_.frame_ms) * (frame + 1);
}

}  // namespace aucast::gui
