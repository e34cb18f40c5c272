#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/app/window/making/au_names.h"
#include "client/app/window/making/chosen_expression.h"
#include "client/app/window/making/own_aus.h"
#include "client/gui/editing/expression_editor.h"
#include "client/gui/editing/transition.h"
#include "client/gui/model/gui_commands.h"
#include "client/pipeline/au_mapping.h"

namespace aucast::app {

/// The expression editor in the window: the recording of one AU, and the face on its way to what
/// the expressions panel has chosen, which can be edited too. What is saved also goes into the
/// mapping's recordings. The constructor's arguments must outlive it. Thread: the player's.
class EditorSession {
 public:
  /// `shown`: the activations of the face in the window, whichever session they come from. A
  /// transition to an expression starts from these.
  EditorSession(const Assets& assets, pipeline::AuMapping& mapping, Notices& notices,
                const std::vector<float>& shown);

  /// Returns true if the editor's face is to be shown. `active`: whether it is shown.
  bool apply(const gui::EditorCommand& command, bool active, Instant now);
  void set_transition(const gui::TransitionSettings& settings) { transition_settings_ = settings; }
  [[nodiscard]] const gui::TransitionSettings& transition() const { return transition_settings_; }

  /// Call it when the mapping has another face. `before`: the names of the previous face's
  /// channels.
  void change_face(const std::vector<std::string>& before);

  /// Call it when another face than the editor's is shown: no expression is chosen any more. What
  /// was edited stays.
  void put_away() { chosen_.clear(); }

  /// Call it when the language has changed: makes all texts anew.
  void change_language();

  /// Writes the AU that is being edited to a file, in the version that was saved last. Returns a
  /// sentence about it.
  [[nodiscard]] Result<std::string> export_au(const std::filesystem::path& file) const;

  /// Imports the AUs of an AU file as the user's own, and shows the first of them. Returns a
  /// sentence about where they were saved.
  [[nodiscard]] Result<std::string> import_aus(const std::filesystem::path& file);

  /// The face on its way to an expression, or what is being edited.
  [[nodiscard]] std::vector<float> activations(Instant now) const;
  /// When activations() change next; nullopt: they stay the same.
  [[nodiscard]] std::optional<Instant> next_frame_at(Instant now) const;
  /// The AUs of which the face is made; while an AU is being edited and has not been changed yet,
  /// that AU. Nullopt if the face is made of muscles.
  [[nodiscard]] std::optional<AuFrame> aus() const;
  /// What a face that is not made of AUs shows, in a form for file names: the name of an expression
  /// made of muscles, an AU that was changed (au12_edited), or "edited".
  [[nodiscard]] std::string made_of() const;
  [[nodiscard]] std::optional<int> au() const { return editor_.au(); }
  [[nodiscard]] bool unsaved() const { return editor_.unsaved() || names_.unsaved(); }
  /// Whether an AU or an unsaved expression is being edited. The editor then keeps it while another
  /// face is shown.
  [[nodiscard]] bool edits() const { return editor_.au() || editor_.unsaved(); }
  /// The AUs of the face as they were asked for and as it shows them; empty if it is made of
  /// muscles.
  [[nodiscard]] std::vector<gui::AuRow> au_rows() const;
  /// The folder of the face into which AUs were saved since the last call; empty: none were.
  [[nodiscard]] std::string take_saved_face() { return std::exchange(saved_face_, {}); }
  /// `active`: whether the editor's face is shown.
  [[nodiscard]] gui::EditorView view(bool active) const;
  /// One button for each expression of the assets, in their order.
  [[nodiscard]] const gui::ExpressionsView& expressions() const { return chosen_.view(); }
  /// The AUs of the face with what they drive.
  [[nodiscard]] const std::shared_ptr<const std::vector<gui::AuEntry>>& known_aus() const {
    return known_aus_;
  }

 private:
  void begin_with_shown();
  bool show_expression(std::size_t index, bool continued, Instant now);
  bool show_aus(const std::string& text, Instant now);
  /// The name that an AU is saved with; empty: none.
  [[nodiscard]] std::string note_of(int number) const;
  bool remove_au(int number, Instant now);
  void go_to(std::vector<float> target, bool continued, Instant now);
  [[nodiscard]] std::string replaced() const;
  void tell_of_replaced(Instant now);
  [[nodiscard]] Result<std::string> save_au(const gui::SaveAu& wanted);
  void saved_in(const std::filesystem::path& file);
  void list_aus();

  const Assets& assets_;
  pipeline::AuMapping& mapping_;
  Notices& notices_;
  const std::vector<float>& shown_;
  OwnAus own_;
  ChosenExpression chosen_;
  gui::ExpressionEditor editor_;
  std::optional<gui::Transition> transition_;
  gui::TransitionSettings transition_settings_;
  std::string saved_face_;
  AuNames names_;
  std::string complaint_;  ///< what is wrong with the AUs that were typed last
  std::shared_ptr<const std::vector<gui::AuEntry>> known_aus_;
};

}  // namespace aucast::app
