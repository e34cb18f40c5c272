#include "client/app/window/playing/playback_history.h"

#include <algorithm>
#include <utility>

namespace aucast::app {
namespace {

constexpr Milliseconds kEvery{250};
constexpr Milliseconds kKept{30'000};
constexpr std::size_t kSamplesMax = 121;
constexpr std::size_t kRateSamples = 9;  // two seconds

PlaybackHistory::Rates rates_of(std::uint64_t in, std::uint64_t out, Duration time) {
  const double span = seconds(time);
  if (!(span > 0)) return {};
  return {static_cast<double>(in) / span, static_cast<double>(out) / span};
}

}  // namespace

bool PlaybackHistory::due(Instant now) const {
  return samples_.empty() || now - samples_.back().slot >= kEvery;
}

void PlaybackHistory::add(Instant now, float fill, const playback::SourceStatus& status,
                          const AuFrame& aus) {
  Sample sample{now, now, fill, status.bytes_received, status.bytes_sent, {}};
  for (std::size_t i = 1; i < kAuCount; ++i) {
    const float intensity = std::max(aus.left[i], aus.right[i]);
    if (intensity > 0) sample.aus[static_cast<int>(i)] = intensity;
  }
  // If the player was busy with other things, this sample stands for that whole time, because the
  // plots are evenly spaced.
  while (!samples_.empty() && now - samples_.back().slot >= 2 * kEvery) {
    Sample held = samples_.back();
    held.slot += kEvery;
    held.at = held.slot;
    samples_.push_back(std::move(held));
    if (samples_.size() > kSamplesMax) samples_.erase(samples_.begin());
  }
  if (!begin_) begin_ = now;
  if (!samples_.empty()) sample.slot = samples_.back().slot + kEvery;
  samples_.push_back(std::move(sample));
  while (now - samples_.front().slot > kKept) samples_.erase(samples_.begin());
}

std::vector<float> PlaybackHistory::fills() const {
  std::vector<float> fills;
  fills.reserve(samples_.size());
  for (const Sample& sample : samples_) fills.push_back(sample.fill);
  return fills;
}

std::vector<gui::AuTrace> PlaybackHistory::traces() const {
  std::map<int, float> peaks;
  for (const Sample& sample : samples_) {
    for (const auto& [number, intensity] : sample.aus) {
      peaks[number] = std::max(peaks[number], intensity);
    }
  }
  std::vector<std::pair<float, int>> strongest;
  for (const auto& [number, peak] : peaks) strongest.emplace_back(-peak, number);
  std::sort(strongest.begin(), strongest.end());
  if (strongest.size() > gui::kTracesMax) strongest.resize(gui::kTracesMax);
  std::vector<gui::AuTrace> traces;
  for (const auto& [peak, number] : strongest) {
    gui::AuTrace trace{number, {}};
    for (const Sample& sample : samples_) {
      const auto found = sample.aus.find(number);
      trace.values.push_back(found == sample.aus.end() ? 0.0F : found->second);
    }
    traces.push_back(std::move(trace));
  }
  std::sort(traces.begin(), traces.end(),
            [](const gui::AuTrace& a, const gui::AuTrace& b) { return a.number < b.number; });
  return traces;
}

PlaybackHistory::Rates PlaybackHistory::rates() const {
  if (samples_.empty()) return {};
  const Sample& last = samples_.back();
  const Sample& first = samples_[samples_.size() - std::min(samples_.size(), kRateSamples)];
  return rates_of(last.bytes_in - first.bytes_in, last.bytes_out - first.bytes_out,
                  last.at - first.at);
}

PlaybackHistory::Rates PlaybackHistory::mean_rates() const {
  if (!begin_) return {};
  const Sample& last = samples_.back();
  return rates_of(last.bytes_in, last.bytes_out, last.at - *begin_);
}

}  // namespace aucast::app
