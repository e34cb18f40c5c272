#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "client/gui/history.h"

namespace aucast::gui {

/// The expression editor of thesis 5.4.3 without its widgets: the activations of every channel, the
/// AU they are meant for, and every step so that it can be taken back. Loading another AU is a step
/// like any other, so that unsaved changes are never lost.
/// Face and recordings must outlive it; the recordings may change meanwhile.
class ExpressionEditor {
 public:
  ExpressionEditor(const face::Face& face, const face::AuRecordings& recordings);

  /// One per channel of the face.
  [[nodiscard]] const std::vector<float>& activations() const { return history_.now().activations; }
  /// The AU being edited; nothing: a free expression.
  [[nodiscard]] std::optional<int> au() const { return history_.now().au; }
  /// There is something that save would change: edits since the AU was loaded or saved.
  [[nodiscard]] bool unsaved() const { return history_.now().activations != history_.now().stored; }
  [[nodiscard]] bool can_undo() const { return history_.can_undo(); }
  [[nodiscard]] bool can_redo() const { return history_.can_redo(); }
  [[nodiscard]] bool linked() const { return linked_; }

  /// With `linked`, setting a channel sets its partner on the other side too.
  void set_linked(bool linked) { linked_ = linked; }
  /// Sets a channel, clamped to its range. `continued`: this belongs to the step before, as the
  /// many values of one drag do.
  void set(std::size_t channel, float activation, bool continued);
  /// Begins to edit an AU: its recording, or the neutral face for one that has none.
  void load(int au);
  /// Takes a whole face over as a free expression; `continued` as for set().
  void take(const std::vector<float>& activations, bool continued);
  /// All channels to 0; the AU stays.
  void neutral();
  /// Back to what was loaded or saved last.
  void revert();
  /// What is shown has been saved as `au`.
  void saved(int au);
  /// The recordings of AUs have become others, or have gone; that of `au` is what is shown now. A
  /// step that is taken back brings what was there as a change that is not saved.
  void recorded_anew(int au);
  /// The face has become another one; `before` are the names of the channels that it had. What is
  /// not saved goes along by the names of the channels, in every step; the rest is as the
  /// recordings of this face have it.
  void change_face(const std::vector<std::string>& before);
  void undo() { history_.undo(); }
  void redo() { history_.redo(); }

 private:
  [[nodiscard]] std::vector<float> recording_of(int au) const;

  struct State {
    std::vector<float> activations;
    std::vector<float> stored;  ///< what the file has
    std::optional<int> au;
  };

  const face::Face& face_;
  const face::AuRecordings& recordings_;
  /// More steps than anybody takes back; a step of a large face is a kilobyte.
  static constexpr std::size_t kStepsMax = 1000;

  History<State> history_{kStepsMax};
  bool linked_ = true;
};

/// The channel that is the mirror image of this one by its name, left_X and right_X.
[[nodiscard]] std::optional<std::size_t> partner_of(const face::Face& face, std::size_t channel);

}  // namespace aucast::gui
