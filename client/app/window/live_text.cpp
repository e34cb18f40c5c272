#include "client/app/window/live_text.h"

#include "client/app/steady.h"
#include "common/log.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

std::string ms_text(Duration time) {
  return std::to_string(std::chrono::round<Milliseconds>(time).count());
}

}  // namespace

std::string live_objection(const PlaybackOptions& options, const playback::SourceStatus& status) {
  if (!options.buffers.low_delay || status.live) return {};
  if (!options.file.empty()) return "--live changes nothing: a file is not live";
  if (!status.negotiated) {
    return "--live changes nothing: a classic server cannot say that its stream is live";
  }
  return "--live changes nothing: this stream is recorded, not live";
}

std::string delay_text(const playback::DelaySummary& delay, Milliseconds wanted) {
  if (delay.keyframes == 0) return {};
  return ms_text(delay.median) + " ms (at most " + ms_text(delay.longest) + ", wanted " +
         ms_text(wanted) + ")";
}

void trace_reached(const AuFrame& aus, Instant now) {
  if (!spdlog::should_log(spdlog::level::trace)) return;
  spdlog::trace("reached {{{}}} at {:.6f}", protocol::format_au_set(aus),
                seconds(now.time_since_epoch()));
}

}  // namespace aucast::app
