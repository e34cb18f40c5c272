#include "client/app/window/making/editor_session.h"

#include <array>
#include <utility>
#include <variant>

#include "client/face/face_folder.h"
#include "client/gui/editing/channel_groups.h"
#include "client/gui/model/view_text.h"
#include "client/gui/texts/texts.h"
#include "common/action_unit.h"
#include "common/files.h"
#include "common/overloaded.h"
#include "protocol/codec.h"

namespace aucast::app {

EditorSession::EditorSession(const Assets& assets, pipeline::AuMapping& mapping, Notices& notices,
                             const std::vector<float>& shown)
    : assets_(assets),
      mapping_(mapping),
      notices_(notices),
      shown_(shown),
      own_(assets, mapping),
      chosen_(assets, mapping),
      editor_(mapping.face, mapping.recordings) {
  list_aus();
}

/// Begins to edit the face in the window, which another session shows, as a free expression. If
/// something is being edited already, goes on with that.
void EditorSession::begin_with_shown() {
  if (edits() || editor_.activations() == shown_) return;
  transition_.reset();
  chosen_.clear();
  editor_.take(shown_, false);
}

bool EditorSession::apply(const gui::EditorCommand& command, bool active, Instant now) {
  const bool of_sliders = std::holds_alternative<gui::SetChannel>(command) ||
                          std::holds_alternative<gui::SaveAu>(command);
  if (of_sliders && !active) begin_with_shown();
  // What is edited is shown at once, and is no longer the expression or the combined AUs.
  const auto edit = [&](auto change) {
    transition_.reset();
    chosen_.clear();
    change();
    return true;
  };
  const Overloaded carry_out{
      [&](const gui::ShowExpression& one) { return show_expression(one.index, false, now); },
      [&](const gui::ChangeStrength& one) {
        const auto chosen = chosen_.set_strength(one.percent);
        return chosen && show_expression(*chosen, one.continued, now);
      },
      [&](const gui::ShowAus& one) { return show_aus(one.aus, now); },
      [&](const gui::ChangeTransition& one) {
        transition_settings_ = one.settings;
        return false;
      },
      [&](const gui::SetChannel& one) {
        const bool known =
            one.channel >= 0 && static_cast<std::size_t>(one.channel) < shown_.size();
        return known && edit([&] {
                 editor_.set(static_cast<std::size_t>(one.channel), one.value, one.continued);
               });
      },
      [&](const gui::SetLinked& one) {
        editor_.set_linked(one.linked);
        return false;
      },
      [&](const gui::LoadAu& one) {
        tell_of_replaced(now);
        return edit([&] { editor_.load(one.number); });
      },
      [](const gui::ShowEdited&) { return true; },
      [&](const gui::SaveAu& one) {
        notices_.tell(save_au(one), now);
        return false;
      },
      [&](const gui::NameAu& one) {
        names_.type(one.number, one.name, note_of(one.number));
        return false;
      },
      [&](const gui::RemoveAu& one) { return remove_au(one.number, now); },
      [&](const gui::RevertAu&) {
        names_.revert();
        return edit([&] { editor_.revert(); });
      },
      [&](const gui::NeutralFace&) { return edit([&] { editor_.neutral(); }); },
      [&](const gui::Undo&) { return edit([&] { editor_.undo(); }); },
      [&](const gui::Redo&) { return edit([&] { editor_.redo(); }); }};
  return std::visit(carry_out, command);
}

bool EditorSession::show_expression(std::size_t index, bool continued, Instant now) {
  if (index >= assets_.expressions.size()) return false;
  auto target = chosen_.choose(index);
  if (!target) {
    notices_.say(target.error().message, true, now);
    return false;
  }
  go_to(*std::move(target), continued, now);
  return true;
}

bool EditorSession::show_aus(const std::string& text, Instant now) {
  const auto aus = protocol::parse_au_set(text);
  if (!aus) {
    complaint_ = aus.error().message;
    notices_.say(complaint_, true, now);
    return false;
  }
  if (notices_.view().text == complaint_) notices_.clear();
  go_to(chosen_.put_together(*aus), false, now);
  return true;
}

void EditorSession::change_language() {
  list_aus();
  chosen_.change_language();
}

/// A sentence for when another face comes into the editor; empty if what is there is saved.
std::string EditorSession::replaced() const {
  return editor_.unsaved() ? gui::tr("said.edit_replaced") : std::string();
}

void EditorSession::tell_of_replaced(Instant now) {
  if (const std::string text = replaced(); !text.empty()) notices_.say(text, false, now);
}

/// The editor takes `target`; the face goes there from the one that is shown.
void EditorSession::go_to(std::vector<float> target, bool continued, Instant now) {
  tell_of_replaced(now);
  editor_.take(target, continued);
  transition_.emplace(shown_, std::move(target), transition_settings_, now);
}

void EditorSession::change_face(const std::vector<std::string>& before) {
  transition_.reset();
  own_.change_face();
  names_.change_face();
  editor_.change_face(before);
  list_aus();
  const std::optional<AuFrame>& chosen = chosen_.aus();
  if (!chosen) return;
  // What is made of AUs is made of the same ones.
  std::vector<float> target(mapping_.face.channels.size());
  face::mix(mapping_.face.channels, mapping_.recordings, *chosen, mapping_.mixer, target);
  editor_.take(target, true);
}

std::string EditorSession::note_of(int number) const {
  const auto saved = mapping_.recordings.find(number);
  return saved == mapping_.recordings.end() ? std::string() : saved->second.note;
}

/// Returns a sentence about where it was saved.
Result<std::string> EditorSession::save_au(const gui::SaveAu& wanted) {
  const std::string name = names_.name_for(wanted.number, wanted.name);
  if (name.empty() && !facs_name(wanted.number) && note_of(wanted.number).empty()) {
    return Error{ErrorKind::Usage, gui::tr("said.au_unnamed", wanted.number)};
  }
  const auto file = own_.save(wanted.number, editor_.activations(), name);
  if (!file) return file.error();
  names_.saved(wanted.number);
  editor_.saved(wanted.number);
  saved_in(*file);
  return gui::tr("said.au_saved", wanted.number, file->string());
}

void EditorSession::saved_in(const std::filesystem::path& file) {
  list_aus();
  saved_face_ = whole_path(file.parent_path()).string();
}

Result<std::string> EditorSession::import_aus(const std::filesystem::path& file) {
  auto recordings = face::load_aus(file, mapping_.face);
  if (!recordings) return recordings.error();
  recordings->erase(0);  // the neutral face, which is no AU
  if (recordings->empty()) {
    return Error{ErrorKind::BadData, file.string() + ": " + gui::tr("said.no_aus")};
  }
  const auto saved = own_.take(*recordings);
  if (!saved) return saved.error();
  const std::string lost = replaced();
  transition_.reset();
  chosen_.clear();
  editor_.recorded_anew(recordings->begin()->first);
  saved_in(*saved);
  std::string numbers;
  for (const auto& [number, recording] : *recordings) {
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(number);
  }
  const std::string imported = gui::tr("said.aus_imported", numbers, saved->string());
  return lost.empty() ? imported : imported + "\n" + lost;
}

bool EditorSession::remove_au(int number, Instant now) {
  if (!own_.differs_from_shipped(number)) return false;
  const bool shipped = own_.shipped(number);
  const std::string name = note_of(number);
  if (const auto removed = own_.remove(number); !removed) {
    notices_.say(removed.error().message, true, now);
    return false;
  }
  names_.removed(number, shipped ? std::string() : name);
  transition_.reset();
  chosen_.clear();
  editor_.recorded_anew(number);
  list_aus();
  notices_.say(shipped ? gui::tr("said.au_shipped", number) : gui::tr("said.au_deleted", number),
               false, now);
  return true;
}

Result<std::string> EditorSession::export_au(const std::filesystem::path& file) const {
  if (!editor_.au()) return Error{ErrorKind::Usage, gui::tr("said.no_au")};
  return own_.export_to(*editor_.au(), file);
}

void EditorSession::list_aus() {
  known_aus_ = std::make_shared<const std::vector<gui::AuEntry>>(own_.entries());
}

std::vector<float> EditorSession::activations(Instant now) const {
  return transition_ && !transition_->over(now) ? transition_->at(now) : editor_.activations();
}

std::optional<Instant> EditorSession::next_frame_at(Instant now) const {
  return transition_ ? transition_->next_frame_at(now) : std::nullopt;
}

std::optional<AuFrame> EditorSession::aus() const {
  if (chosen_.aus() || !editor_.au() || editor_.unsaved()) return chosen_.aus();
  const std::array terms = {AuTerm{static_cast<std::uint8_t>(*editor_.au()), Side::Both, 100}};
  return frame_from_terms(terms);
}

std::vector<gui::AuRow> EditorSession::au_rows() const {
  const auto made_of_aus = chosen_.au_rows().empty() ? aus() : std::nullopt;
  return made_of_aus ? gui::au_rows(*made_of_aus, *made_of_aus, {}, mapping_.recordings)
                     : chosen_.au_rows();
}

std::string EditorSession::made_of() const {
  if (std::string name = chosen_.name(); !name.empty()) return name;
  return editor_.au() ? "au" + std::to_string(*editor_.au()) + "_edited" : "edited";
}

gui::EditorView EditorSession::view(bool active) const {
  gui::EditorView view;
  view.active = active;
  view.aside = !active && edits();
  // What a muscle would be moved from, and what would be saved.
  const bool begun = active || edits();
  view.groups = gui::channel_groups(mapping_.face, begun ? editor_.activations() : shown_);
  view.linked = editor_.linked();
  view.au = editor_.au().value_or(-1);
  view.unsaved = unsaved();
  view.names = names_.view();
  view.can_undo = editor_.can_undo();
  view.can_redo = editor_.can_redo();
  view.compound = chosen_.au_rows();
  return view;
}

}  // namespace aucast::app
