#include "common/sources/resample.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/check.h"

namespace aucast::sources {
namespace {

/// A stream read as a curve over time; times are asked for in ascending order.
class Curve {
 public:
  Curve(const protocol::StreamFile& stream, std::uint32_t keyframe_ms)
      : stream_(stream), keyframe_ms_(keyframe_ms) {
    enter(0);
  }

  AuFrame at(double ms) {
    while (ms > end_ms_ && index_ + 1 < stream_.keyframes.size()) {
      from_ = to_;
      begin_ms_ = end_ms_;
      enter(index_ + 1);
    }
    const double length = end_ms_ - begin_ms_;
    const double share = length > 0 ? (ms - begin_ms_) / length : 1;
    return between(from_, to_, std::clamp(share, 0.0, 1.0));
  }

 private:
  void enter(std::size_t index) {
    index_ = index;
    const protocol::Keyframe& keyframe = stream_.keyframes[index];
    to_ = frame_from_terms(keyframe.terms);
    end_ms_ = begin_ms_ + keyframe.time_ms.value_or(keyframe_ms_);
  }

  const protocol::StreamFile& stream_;
  std::uint32_t keyframe_ms_;
  std::size_t index_ = 0;
  AuFrame from_;
  AuFrame to_;
  double begin_ms_ = 0;
  double end_ms_ = 0;
};

}  // namespace

protocol::StreamFile resample(const protocol::StreamFile& stream, double rate,
                              std::uint32_t keyframe_ms, const std::stop_token& stop) {
  AUCAST_CHECK(rate > 0 && rate <= kRateMax);
  AUCAST_CHECK(!stream.keyframes.empty());
  const std::uint64_t whole_ms = protocol::media_ms(stream, keyframe_ms);
  Curve curve(stream, keyframe_ms);
  protocol::StreamFile resampled{{}, stream.title};
  std::uint64_t place = 0;
  for (std::uint64_t step = 1; place < whole_ms && !stop.stop_requested(); ++step) {
    const double wanted = std::round(static_cast<double>(step) * 1000 / rate);
    const std::uint64_t next =
        wanted < static_cast<double>(whole_ms) ? static_cast<std::uint64_t>(wanted) : whole_ms;
    protocol::Keyframe keyframe;
    keyframe.terms = canonical_terms(curve.at(static_cast<double>(next)));
    keyframe.time_ms = static_cast<std::uint32_t>(next - place);
    resampled.keyframes.push_back(std::move(keyframe));
    place = next;
  }
  // A stream without any time is one face.
  if (resampled.keyframes.empty()) return stream;
  return resampled;
}

}  // namespace aucast::sources
