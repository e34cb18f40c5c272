#include <array>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>
#include <variant>

#include "client/app/window/composition_file.h"
#include "client/app/window/window_session.h"
#include "client/face/au_blender.h"
#include "client/gui/aus_file.h"
#include "client/playback/file_source.h"
#include "common/files.h"
#include "protocol/codec.h"
#include "protocol/limits.h"

// The part of the session that carries out what the composer asks for.

namespace aucast::app {
namespace {

constexpr const char* kFirstName = "composed.txt";

std::string time_of(const gui::ComposedKeyframe& keyframe) {
  return keyframe.ms ? std::to_string(*keyframe.ms) + " ms" : "untimed";
}

int percent_of(float intensity) {
  return static_cast<int>(std::lround(intensity * 100));
}

std::string total_of(const gui::Composer::Keyframes& keyframes) {
  if (keyframes.empty()) return "no keyframes yet";
  const auto untimed = static_cast<std::uint32_t>(protocol::kDefaultKeyframeTime.count());
  std::uint64_t ms = 0;
  for (const auto& keyframe : keyframes) ms += keyframe->ms.value_or(untimed);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%zu keyframe%s, %.2f s", keyframes.size(),
                keyframes.size() == 1 ? "" : "s", static_cast<double>(ms) / 1000);
  return text.data();
}

}  // namespace

void WindowSession::carry_out(const gui::ComposerCommand& command, Instant now) {
  std::visit([&](const auto& one) { compose(one, now); }, command);
  show_composed();
}

/// What follows from another state of the composer, or from other rules.
void WindowSession::show_composed() {
  composed_.assign(face_.channels.size(), 0.0F);
  face::mix(face_, face::blend(rules_, composer_.current().aus), animation_.mixer, composed_);
  if (composer_rows_ != nullptr && composed_revision_ == composer_.revision()) return;
  composed_revision_ = composer_.revision();
  std::vector<gui::TimelineRow> rows;
  for (const auto& keyframe : composer_.keyframes()) {
    rows.push_back({protocol::format_au_set(keyframe->aus), time_of(*keyframe)});
  }
  composer_rows_ = std::make_shared<const std::vector<gui::TimelineRow>>(std::move(rows));
  composer_total_ = total_of(composer_.keyframes());
}

/// The composer takes the face; what plays waits.
void WindowSession::edit_composition(Instant now) {
  carry_out(gui::Pause{}, now);
  shown_ = Shown::Composer;
  transition_.reset();
  pad_at_.reset();
}

void WindowSession::compose(const gui::ComposeAu& command, Instant now) {
  edit_composition(now);
  composer_.set_au(command.number, command.left_percent, command.right_percent, command.continued);
}

void WindowSession::compose(const gui::ComposeMood& command, Instant now) {
  edit_composition(now);
  pad_at_ = {command.x, command.y};
  composer_.set_aus(gui::pad_face(*pad_, command.x, command.y), command.continued);
}

void WindowSession::compose(const gui::ComposeNeutral&, Instant now) {
  edit_composition(now);
  composer_.set_aus({}, false);
}

void WindowSession::compose(const gui::ComposeTime& command, Instant) {
  std::optional<std::uint32_t> ms;
  if (command.ms >= 0) ms = static_cast<std::uint32_t>(command.ms);
  composer_.set_time(ms, command.continued);
}

void WindowSession::compose(const gui::AddKeyframe&, Instant now) {
  edit_composition(now);
  composer_.add();
}

void WindowSession::compose(const gui::ChooseKeyframe& command, Instant now) {
  edit_composition(now);
  std::optional<std::size_t> keyframe;
  if (command.keyframe >= 0) keyframe = static_cast<std::size_t>(command.keyframe);
  composer_.choose(keyframe);
}

void WindowSession::compose(const gui::RemoveKeyframe&, Instant now) {
  edit_composition(now);
  composer_.remove();
}

void WindowSession::compose(const gui::MoveKeyframe& command, Instant now) {
  edit_composition(now);
  composer_.move(command.direction);
}

void WindowSession::compose(const gui::UndoComposing&, Instant now) {
  edit_composition(now);
  composer_.undo();
}

void WindowSession::compose(const gui::RedoComposing&, Instant now) {
  edit_composition(now);
  composer_.redo();
}

void WindowSession::compose(const gui::NewComposition&, Instant now) {
  edit_composition(now);
  composer_.begin_anew();
}

void WindowSession::compose(const gui::PlayComposition&, Instant now) {
  std::vector<playback::TimedAus> keyframes;
  for (const auto& keyframe : composer_.keyframes()) {
    playback::TimedAus timed{keyframe->aus, std::nullopt};
    if (keyframe->ms) timed.duration = Milliseconds(*keyframe->ms);
    keyframes.push_back(timed);
  }
  if (keyframes.empty()) return;
  const std::filesystem::path file = composer_.file();
  replace_source(std::make_unique<playback::FileSource>(keyframes), options_.playback.speed, now);
  play_local(file.empty() ? "composed stream" : file.filename().string(), keyframes);
}

void WindowSession::compose(const gui::SaveComposition&, Instant now) {
  if (!composer_.file().empty()) return save_composition(composer_.file(), now);
  browser_.open(gui::Purpose::SaveStream, own_folder(), kFirstName);
}

void WindowSession::load_composition(const std::filesystem::path& file, Instant now) {
  auto read = read_stream(file);
  if (!read) return browser_.refuse(read.error().message);
  std::vector<gui::ComposedKeyframe> keyframes;
  for (const playback::TimedAus& timed : *read) {
    gui::ComposedKeyframe keyframe{timed.aus, std::nullopt};
    if (timed.duration) keyframe.ms = static_cast<std::uint32_t>(timed.duration->count());
    keyframes.push_back(keyframe);
  }
  browser_.close();
  last_folder_ = file.parent_path();
  edit_composition(now);
  composer_.load(keyframes, file.string());
  show_composed();
}

/// A file that is replaced stays beside the new one, with a ~ at its end: it may have comments.
void WindowSession::save_composition(const std::filesystem::path& file, Instant now) {
  const auto saved = save_stream(composer_.keyframes(), file);
  if (!saved) {
    if (browser_.view().open) return browser_.refuse(saved.error().message);
    return say(saved.error().message, true, now);
  }
  browser_.close();
  own_folder_ = file.parent_path();
  composer_.saved(file.string());
  show_composed();
  say(*saved, false, now);
}

/// The AUs of the face with what they drive, for the list of the expression editor.
void WindowSession::list_aus() {
  std::vector<gui::AuEntry> entries;
  for (const auto& [number, recording] : face_.recordings) {
    if (number == 0) continue;
    gui::AuEntry entry;
    entry.number = number;
    const auto name = facs_name(number);
    entry.name = name ? std::string(*name) : recording.note;
    entry.muscles = gui::drive_in_words(gui::drive_of(face_, recording.activation));
    const auto looks = assets_.au_looks.find(number);
    if (looks != assets_.au_looks.end()) entry.looks = looks->second;
    entries.push_back(std::move(entry));
  }
  known_aus_ = std::make_shared<const std::vector<gui::AuEntry>>(std::move(entries));
}

/// What is played, from its beginning: a file as it is, of a server what has come so far.
void WindowSession::export_keyframes(const std::filesystem::path& file, Instant now) {
  gui::Composer::Keyframes keyframes;
  const auto add = [&](const AuFrame& aus, std::optional<std::uint32_t> ms) {
    keyframes.push_back(
        std::make_shared<const gui::ComposedKeyframe>(gui::ComposedKeyframe{aus, ms}));
  };
  for (const gui::ComposedKeyframe& one : received_) add(one.aus, one.ms);
  if (local_) {
    for (const playback::TimedAus& one : local_->keyframes()) {
      std::optional<std::uint32_t> ms;
      if (one.duration) ms = static_cast<std::uint32_t>(one.duration->count());
      add(one.aus, ms);
    }
  }
  if (keyframes.empty()) return browser_.refuse("nothing has been played that could be exported");
  const auto saved = save_stream(keyframes, file);
  if (!saved) return browser_.refuse(saved.error().message);
  browser_.close();
  own_folder_ = file.parent_path();
  say(std::to_string(keyframes.size()) + " keyframes " + *saved, false, now);
}

void WindowSession::undo(Instant now) {
  if (shown_ == Shown::Editor) return apply(gui::Undo{}, now);
  if (shown_ == Shown::Composer) apply(gui::ComposerCommand(gui::UndoComposing{}), now);
}

void WindowSession::redo(Instant now) {
  if (shown_ == Shown::Editor) return apply(gui::Redo{}, now);
  if (shown_ == Shown::Composer) apply(gui::ComposerCommand(gui::RedoComposing{}), now);
}

void WindowSession::save(Instant now) {
  if (shown_ == Shown::Editor && editor_.au()) return apply(gui::SaveAu{*editor_.au()}, now);
  if (shown_ == Shown::Composer) apply(gui::ComposerCommand(gui::SaveComposition{}), now);
}

/// Where files of the user's own go: where the last one went, first the current folder.
std::filesystem::path WindowSession::own_folder() const {
  return own_folder_.empty() ? std::filesystem::path(".") : own_folder_;
}

gui::ComposerView WindowSession::composer_view() const {
  gui::ComposerView view;
  const gui::ComposedKeyframe& current = composer_.current();
  view.active = shown_ == Shown::Composer;
  view.rows = composer_rows_;
  view.total = composer_total_;
  if (composer_.chosen()) view.chosen = static_cast<int>(*composer_.chosen());
  for (int number = 1; number <= kAuNumberMax; ++number) {
    const auto index = static_cast<std::size_t>(number);
    const int left = percent_of(current.aus.left[index]);
    const int right = percent_of(current.aus.right[index]);
    if (left == 0 && right == 0) continue;
    view.aus.push_back({number, std::string(facs_name(number).value_or("")), left, right});
  }
  if (current.ms) view.ms = static_cast<int>(*current.ms);
  view.file = composer_.file();
  view.unsaved = composer_.unsaved();
  view.can_undo = composer_.can_undo();
  view.can_redo = composer_.can_redo();
  view.pad = pad_;
  view.pad_at = pad_at_;
  return view;
}

}  // namespace aucast::app
