#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/action_unit.h"
#include "common/sources/conditioning.h"
#include "common/sources/dead_band.h"
#include "common/sources/timeline.h"
#include "protocol/packet.h"

namespace aucast::sources {

/// A keyframe of a live source.
struct LiveKeyframe {
  protocol::Keyframe keyframe;
  double seconds = 0;    ///< its time on the source's clock
  bool begins = false;   ///< the clock began, began again, or jumped
  bool clocked = false;  ///< the source has a clock of its own
};

/// Turns the samples of a live face into keyframes, one by one, as they come. A keyframe takes the
/// time between its sample and the previous one, on the source's clock; after a pause, it takes the
/// usual time instead, and the pause is left out. Channels without data hold for kHoldSeconds, then
/// ease to neutral; when no samples come at all, idle() makes the keyframes for this.
class LiveTimeline {
 public:
  /// `rate`: the most keyframes a second; samples between them are left out. nullopt: no limit.
  /// `settings` apply to rows of a table, not to lines of a stream file.
  explicit LiveTimeline(std::optional<double> rate, const ConditioningSettings& settings = {})
      : rate_(rate), conditioning_(settings), dead_band_(settings.profile.dead_band) {}

  /// Takes `update`, a sample of the source at `seconds`, later than the previous one; a negative
  /// intensity is no data. `time_ms`: the time that a line of a stream file gives; nullopt: the
  /// sample is a table's row, whose time is the clock's.
  void add(double seconds, const AuFrame& update, std::optional<std::uint32_t> time_ms = {});
  /// The clock began again: the next sample comes one usual step after the last.
  void restart() { restarted_ = true; }
  /// Uses other settings from the next sample on; a neutral face that was measured is kept.
  void change(const ConditioningSettings& settings);
  /// The scale has changed: the neutral face is measured again.
  void forget_neutral() { conditioning_.forget_neutral(); }
  /// As Conditioning::take_neutral().
  [[nodiscard]] std::optional<MeasuredNeutral> take_neutral() {
    return conditioning_.take_neutral();
  }
  /// Whether the source has a clock of its own, for the samples that follow.
  void set_clocked(bool clocked) { clocked_ = clocked; }

  /// Call this when nothing has come for `silence_seconds`: makes the keyframes that are due by
  /// now.
  void idle(double silence_seconds);
  /// The silence after which to call idle(); nullopt once the face is neutral.
  [[nodiscard]] std::optional<double> idle_due_seconds() const;

  /// The keyframes since the last call.
  [[nodiscard]] std::vector<LiveKeyframe> take();

 private:
  [[nodiscard]] double step_to(double seconds);
  void emit(const AuFrame& frame, double seconds);

  std::optional<double> rate_;
  Conditioning conditioning_;
  DeadBand dead_band_;
  Channels channels_;
  std::vector<LiveKeyframe> keyframes_;
  std::optional<double> last_seconds_;  ///< on the source's clock
  double usual_seconds_ = 0.04;         ///< between two samples
  double age_clock_seconds_ = 0;        ///< the clock by which data gets old
  double place_seconds_ = 0;            ///< of the last sample, on the keyframes' clock
  std::int64_t emitted_ms_ = 0;         ///< place of the last keyframe
  std::size_t idle_steps_ = 0;          ///< keyframes that eased, since the last sample
  bool restarted_ = true;
  bool begins_ = true;  ///< whether the next keyframe `begins`
  bool clocked_ = false;
  bool verbatim_ = false;  ///< the last sample was a stream file's line
  bool said_anything_ = false;
};

}  // namespace aucast::sources
