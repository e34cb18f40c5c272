#include "client/app/live_text.h"

#include "client/gui/texts.h"

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
  return gui::tr("state.delay", ms_text(delay.median), ms_text(delay.longest), ms_text(wanted));
}

}  // namespace aucast::app
