#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/app/window/making/own_aus.h"
#include "client/gui/expression_editor.h"
#include "client/gui/gui_commands.h"
#include "client/gui/transition.h"
#include "client/pipeline/au_mapping.h"

namespace aucast::app {

/// The expression panel and the expression editor in the window: named expressions, AUs put
/// together, and the recording of one AU. What is saved goes into the mapping's recordings too.
/// What the constructor takes must outlive it. Thread: the player's.
class EditorSession {
 public:
  /// `shown`: the activations of the face in the window, whichever session they are from; an
  /// expression is reached from there.
  EditorSession(const Assets& assets, pipeline::AuMapping& mapping, Notices& notices,
                const std::vector<float>& shown);

  /// Begins with the face that is shown, which is not the editor's, as a free expression; changes
  /// that are not saved go on instead.
  void begin_with_shown();
  /// True when the editor's face is to be shown.
  bool apply(const gui::EditorCommand& command, Instant now);
  void set_transition(const gui::TransitionSettings& settings) { transition_settings_ = settings; }
  [[nodiscard]] const gui::TransitionSettings& transition() const { return transition_settings_; }

  /// The face of the mapping has become another one; `before`: the names of the channels it had.
  void change_face(const std::vector<std::string>& before);

  /// Another face is shown than the editor's: no expression is chosen any more. What was edited
  /// stays.
  void put_away() { show_none_of_them(); }

  /// What is in words is said anew.
  void change_language();

  /// Writes the AU that is being edited to a file, as it is saved. Returns a sentence about it.
  [[nodiscard]] Result<std::string> export_au(const std::filesystem::path& file) const;

  /// Takes the AUs of a file of AUs over as one's own, and shows the first. Returns a sentence
  /// about where they went.
  [[nodiscard]] Result<std::string> import_aus(const std::filesystem::path& file);

  /// The expression on its way, or what is being edited.
  [[nodiscard]] std::vector<float> activations(Instant now) const;
  /// When activations() change next; nullopt while they stay the same.
  [[nodiscard]] std::optional<Instant> next_frame_at(Instant now) const;
  /// The AUs that the face is made of, an AU that is edited and not changed yet among them; nothing
  /// when it is made of muscles.
  [[nodiscard]] std::optional<AuFrame> aus() const;
  /// What the face is where it is not made of AUs, as part of a name: an AU that was changed, an
  /// expression of muscles, or "edited".
  [[nodiscard]] std::string made_of() const;
  [[nodiscard]] std::optional<int> au() const { return editor_.au(); }
  [[nodiscard]] bool unsaved() const { return editor_.unsaved() || !names_.empty(); }
  /// The last saving of an AU.
  [[nodiscard]] bool save_failed() const { return save_failed_; }
  /// The folder of the face that was saved to; empty: nothing was saved.
  [[nodiscard]] const std::string& saved_face() const { return saved_face_; }
  /// `active`: the editor's face is shown.
  [[nodiscard]] gui::EditorView view(bool active) const;
  /// The buttons are one for each expression, in their order.
  [[nodiscard]] const gui::ExpressionsView& expressions() const { return expressions_; }
  /// The AUs of the face with what they drive.
  [[nodiscard]] const std::shared_ptr<const std::vector<gui::AuEntry>>& known_aus() const {
    return known_aus_;
  }

 private:
  bool show_expression(std::size_t index, bool continued, Instant now);
  bool change_strength(const gui::ChangeStrength& change, Instant now);
  bool show_aus(const std::string& text, Instant now);
  /// The face of these AUs, with what became of each of them.
  [[nodiscard]] std::vector<float> put_together(const AuFrame& aus);
  AuFrame explained(std::span<float> target);
  void show_none_of_them();
  void save_au(const gui::SaveAu& wanted, Instant now);
  void name_au(const gui::NameAu& typed);
  /// FACS names it, or the user has.
  [[nodiscard]] bool has_name(int number, const std::string& given) const;
  bool remove_au(int number, Instant now);
  void go_to(std::vector<float> target, bool continued, Instant now);
  [[nodiscard]] Result<std::string> save_recording(const gui::SaveAu& wanted);
  void saved_in(const std::filesystem::path& file);
  void list_aus();

  const Assets& assets_;
  pipeline::AuMapping& mapping_;
  Notices& notices_;
  const std::vector<float>& shown_;
  OwnAus own_;
  gui::ExpressionEditor editor_;
  std::optional<gui::Transition> transition_;
  gui::TransitionSettings transition_settings_;
  bool save_failed_ = false;
  std::string saved_face_;
  std::map<int, std::string> names_;          ///< of AUs, typed and not saved yet
  std::map<int, std::string> deleted_names_;  ///< of AUs, should they be saved again
  std::string complaint_;                     ///< about the AUs that were typed last
  std::optional<AuFrame> aus_;
  AuFrame asked_;                     ///< aus_, before the rules
  std::vector<gui::AuRow> compound_;  ///< what became of aus_
  gui::ExpressionsView expressions_;
  std::shared_ptr<const std::vector<gui::AuEntry>> known_aus_;
};

}  // namespace aucast::app
