#include "client/app/live_text.h"

#include "client/gui/texts/texts.h"

namespace aucast::app {
namespace {

std::string ms_text(Duration time) {
  return std::to_string(std::chrono::round<Milliseconds>(time).count());
}

}  // namespace

LiveObjection live_objection(const PlaybackOptions& options, const playback::SourceStatus& status) {
  if (!options.buffers.low_delay || status.live) return LiveObjection::None;
  if (!options.file.empty()) return LiveObjection::IsFile;
  return status.negotiated ? LiveObjection::IsRecorded : LiveObjection::IsClassic;
}

std::string_view terminal_text(LiveObjection objection) {
  switch (objection) {
    case LiveObjection::None:
      break;
    case LiveObjection::IsFile:
      return "--live changes nothing: a file is not live";
    case LiveObjection::IsClassic:
      return "--live changes nothing: a classic server cannot say that its stream is live";
    case LiveObjection::IsRecorded:
      return "--live changes nothing: this stream is recorded, not live";
  }
  return {};
}

std::string window_text(LiveObjection objection) {
  switch (objection) {
    case LiveObjection::None:
      break;
    case LiveObjection::IsFile:
      return gui::tr("said.live_file");
    case LiveObjection::IsClassic:
      return gui::tr("said.live_classic");
    case LiveObjection::IsRecorded:
      return gui::tr("said.live_recorded");
  }
  return {};
}

std::string delay_text(const playback::DelaySummary& delay, Milliseconds wanted) {
  if (delay.keyframes == 0) return {};
  return gui::tr("state.delay", ms_text(delay.median), ms_text(delay.longest), ms_text(wanted));
}

}  // namespace aucast::app
