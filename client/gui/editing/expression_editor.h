#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "client/gui/editing/history.h"

namespace aucast::gui {

/// The expression editor of thesis 5.4.3 without its widgets: the activations of all channels, the
/// AU that they are meant for, and all steps so that they can be undone. Loading another AU is a
/// step too, so that unsaved changes are never lost. Face and recordings must outlive it; the
/// recordings may change meanwhile.
class ExpressionEditor {
 public:
  ExpressionEditor(const face::Face& face, const face::AuRecordings& recordings);

  /// One per channel of the face.
  [[nodiscard]] const std::vector<float>& activations() const { return history_.now().activations; }
  /// The AU being edited; nullopt: a free expression.
  [[nodiscard]] std::optional<int> au() const { return history_.now().au; }
  /// Whether there are edits since the AU was loaded or saved.
  [[nodiscard]] bool unsaved() const { return history_.now().activations != history_.now().stored; }
  [[nodiscard]] bool can_undo() const { return history_.can_undo(); }
  [[nodiscard]] bool can_redo() const { return history_.can_redo(); }
  [[nodiscard]] bool linked() const { return linked_; }

  /// If linked, setting a channel sets its partner on the other side too.
  void set_linked(bool linked) { linked_ = linked; }
  /// Sets a channel, clamped to its range. `continued`: the change belongs to the previous step,
  /// like the many values of one drag.
  void set(std::size_t channel, float activation, bool continued);
  /// Begins to edit an AU, from its recording or, if it has none, from the neutral face.
  void load(int au);
  /// Takes a whole face as a free expression. `continued`: as for set().
  void take(const std::vector<float>& activations, bool continued);
  /// Sets all channels to 0; the AU stays.
  void neutral();
  /// Goes back to what was loaded or saved last.
  void revert();
  /// Call it when the activations have been saved as `au`.
  void saved(int au);
  /// Call it when recordings have changed or been removed. Loads the recording of `au`. Undoing
  /// this brings the earlier activations back as an unsaved change.
  void recorded_anew(int au);
  /// Call it when the face has been replaced. `before`: the names of the previous face's channels.
  /// In every step, unsaved activations are kept for channels of the same name, and the rest comes
  /// from the recordings of the new face.
  void change_face(const std::vector<std::string>& before);
  void undo() { history_.undo(); }
  void redo() { history_.redo(); }

 private:
  [[nodiscard]] std::vector<float> recording_of(int au) const;

  struct State {
    std::vector<float> activations;
    std::vector<float> stored;  ///< the activations in the file
    std::optional<int> au;
  };

  const face::Face& face_;
  const face::AuRecordings& recordings_;
  /// The number of steps that are kept: more than anybody undoes. For a large face a step takes a
  /// kilobyte.
  static constexpr std::size_t kStepsMax = 1000;

  History<State> history_{kStepsMax};
  bool linked_ = true;
};

/// The mirror image of a channel by its name, right_X for left_X; nullopt: there is none.
[[nodiscard]] std::optional<std::size_t> partner_of(const face::Face& face, std::size_t channel);

}  // namespace aucast::gui
