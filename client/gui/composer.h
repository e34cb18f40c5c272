#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/history.h"
#include "common/action_unit.h"

namespace aucast::gui {

/// One face of a composed stream and the time to reach it.
struct ComposedKeyframe {
  AuFrame aus;
  std::optional<std::uint32_t> ms = 500;  ///< nothing: the time that the player gives
  friend bool operator==(const ComposedKeyframe&, const ComposedKeyframe&) = default;
};

/// A stream in the making, without its widgets: the keyframes, the one being worked on - a chosen
/// one of them, or a new one that is not among them yet - and every step so that it can be taken
/// back. Beginning another stream is a step like any other, so that nothing is ever lost.
class Composer {
 public:
  /// Of one keyframe; the protocol's limit.
  static constexpr std::uint32_t kMsMax = 3'600'000;

  using Keyframes = std::vector<std::shared_ptr<const ComposedKeyframe>>;

  [[nodiscard]] const Keyframes& keyframes() const { return history_.now().keyframes; }
  [[nodiscard]] std::optional<std::size_t> chosen() const { return history_.now().chosen; }
  /// The chosen keyframe, else the new one.
  [[nodiscard]] const ComposedKeyframe& current() const;
  /// Where it was loaded from or saved to; empty: nowhere yet.
  [[nodiscard]] const std::string& file() const { return history_.now().file; }
  /// There is something that saving would keep: keyframes, or a new one that was not added.
  [[nodiscard]] bool unsaved() const;
  [[nodiscard]] bool can_undo() const { return history_.can_undo(); }
  [[nodiscard]] bool can_redo() const { return history_.can_redo(); }
  /// Counts up with everything that changes.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// The intensity of an AU on both sides, in percent. `continued`: this belongs to the step
  /// before, as the many values of one drag do.
  void set_au(int number, int left_percent, int right_percent, bool continued);
  void set_aus(const AuFrame& aus, bool continued);
  /// Cut to what the protocol takes.
  void set_time(std::optional<std::uint32_t> ms, bool continued);
  /// Puts the new keyframe behind the last one; a chosen one is doubled behind itself, and the
  /// double is the chosen one then.
  void add();
  /// Nothing: a new keyframe, that begins as the one worked on until now.
  void choose(std::optional<std::size_t> keyframe);
  void remove();
  /// Moves the chosen one to the front (-1) or the back (+1) by one place.
  void move(int direction);
  void load(const std::vector<ComposedKeyframe>& keyframes, std::string file);
  void begin_anew();
  void saved(const std::string& file);
  void undo();
  void redo();

 private:
  struct State {
    Keyframes keyframes;
    Keyframes stored;  ///< what the file has
    ComposedKeyframe fresh;
    bool fresh_touched = false;  ///< the new keyframe has something that is nowhere else
    std::optional<std::size_t> chosen;
    std::string file;
  };

  void step(State next, bool continued = false);
  void change_current(const ComposedKeyframe& keyframe, bool continued);

  /// More steps than anybody takes back.
  static constexpr std::size_t kStepsMax = 500;

  History<State> history_{kStepsMax};
  std::uint64_t revision_ = 0;
};

}  // namespace aucast::gui
