#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/editing/history.h"
#include "common/action_unit.h"

namespace aucast::gui {

/// A set of AUs and the time to reach it, as the user makes it.
struct ComposedKeyframe {
  AuFrame aus;
  std::optional<std::uint32_t> ms = 500;  ///< the time to reach it; nullopt: the player's default
  friend bool operator==(const ComposedKeyframe&, const ComposedKeyframe&) = default;
};

/// A stream in the making, without its widgets: the keyframes, the current one, and all steps so
/// that they can be undone. The current keyframe is the one that is chosen or, if none is, a new
/// one that is not in the stream yet. Beginning another stream is a step too, so that nothing is
/// ever lost.
class Composer {
 public:
  /// The longest time of a keyframe, as the protocol limits it.
  static constexpr std::uint32_t kMsMax = 3'600'000;
  /// The most bytes of the steps that can be undone, except the last one, which always can.
  static constexpr std::size_t kUndoBytesMax = 64 << 20;

  using Keyframes = std::vector<std::shared_ptr<const ComposedKeyframe>>;

  [[nodiscard]] const Keyframes& keyframes() const { return history_.now().keyframes; }
  [[nodiscard]] std::optional<std::size_t> chosen() const { return history_.now().chosen; }
  /// The chosen keyframe, else the new one.
  [[nodiscard]] const ComposedKeyframe& current() const;
  /// The file that the stream was loaded from or saved to; empty: none yet.
  [[nodiscard]] const std::string& file() const { return history_.now().file; }
  /// The title of the stream that was loaded; empty: none.
  [[nodiscard]] const std::string& title() const { return history_.now().title; }
  /// Whether the stream has changes to be saved. A new keyframe counts once it has been added.
  [[nodiscard]] bool unsaved() const;
  /// Whether a new keyframe was begun and has not been added.
  [[nodiscard]] bool begun() const { return history_.now().fresh_touched; }
  [[nodiscard]] bool can_undo() const { return history_.can_undo(); }
  [[nodiscard]] bool can_redo() const { return history_.can_redo(); }

  /// Sets the intensity of an AU on both sides, in percent; 0: the AU is absent. `continued`: the
  /// change belongs to the previous step, like the many values of one drag.
  void set_au(int number, int left_percent, int right_percent, bool continued);
  void set_aus(const AuFrame& aus, bool continued);
  /// Sets the time of the current keyframe, limited to kMsMax.
  void set_time(std::optional<std::uint32_t> ms, bool continued);
  /// If no keyframe is chosen, appends the new one. Else inserts a copy of the chosen keyframe
  /// right after it, and chooses the copy.
  void add();
  /// Chooses a keyframe; nullopt: a new one, which begins as a copy of the current one.
  void choose(std::optional<std::size_t> keyframe);
  void remove();
  /// Moves the chosen keyframe one place towards the beginning (-1) or the end (+1).
  void move(int direction);
  void load(Keyframes keyframes, std::string file, std::string title);
  void begin_anew();
  void saved(const std::string& file);
  void undo();
  void redo();

 private:
  struct State {
    Keyframes keyframes;
    Keyframes stored;  ///< the keyframes in the file
    ComposedKeyframe fresh;
    bool fresh_touched = false;  ///< `fresh` has AUs that were not added
    std::optional<std::size_t> chosen;
    std::string file;
    std::string title;
  };

  /// For the history, which bounds the steps by it.
  [[nodiscard]] static std::size_t size_of(const State& state, const State& next);
  void step(State next, bool continued = false);
  void change_current(const ComposedKeyframe& keyframe, bool continued);

  /// The number of steps that are kept: more than anybody undoes.
  static constexpr std::size_t kStepsMax = 500;

  History<State> history_{kStepsMax, kUndoBytesMax, size_of};
};

}  // namespace aucast::gui
