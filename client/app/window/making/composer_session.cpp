#include "client/app/window/making/composer_session.h"

#include <utility>
#include <variant>

#include "client/app/stream_files.h"
#include "client/app/window/making/composition_file.h"
#include "client/gui/model/view_text.h"
#include "client/gui/texts/texts.h"
#include "common/overloaded.h"
#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::app {
namespace {

std::string time_of(const gui::ComposedKeyframe& keyframe) {
  return keyframe.ms ? std::to_string(*keyframe.ms) + " ms" : gui::tr("said.no_time");
}

std::string total_of(const gui::Composer::Keyframes& keyframes) {
  if (keyframes.empty()) return gui::tr("said.no_keyframes");
  const auto untimed = static_cast<std::uint32_t>(protocol::kDefaultKeyframeTime.count());
  std::uint64_t ms = 0;
  for (const auto& keyframe : keyframes) ms += keyframe->ms.value_or(untimed);
  return gui::tr("said.total", gui::keyframes_text(keyframes.size()),
                 gui::seconds_text(static_cast<double>(ms) / 1000));
}

std::vector<gui::PadPoint> pad_of(const std::vector<Expression>& expressions) {
  std::vector<gui::PadPoint> points;
  for (const Expression& expression : expressions) {
    if (!expression.pad) continue;
    points.push_back(
        {expression.label, (*expression.pad)[0], (*expression.pad)[1], expression.aus});
  }
  return points;
}

}  // namespace

ComposerSession::ComposerSession(const Assets& assets, const pipeline::AuMapping& mapping,
                                 Notices& notices)
    : mapping_(mapping),
      notices_(notices),
      activations_(mapping.face.channels.size()),
      pad_(std::make_shared<const std::vector<gui::PadPoint>>(pad_of(assets.expressions))) {
  list_keyframes();
}

ComposerSession::Next ComposerSession::apply(const gui::ComposerCommand& command, bool active,
                                             const std::optional<AuFrame>& seen, Instant now) {
  // What is composed is shown at once, and is no longer of the pad.
  const auto edit = [&](auto change) {
    pad_at_.reset();
    change();
    remake();
    list_keyframes();
    return Next::Show;
  };
  const auto take = [&] { return edit([&] { composer_.set_aus(*seen, false); }); };
  const Overloaded carry_out{
      [&](const gui::ComposeAu& au) {
        return edit(
            [&] { composer_.set_au(au.number, au.left_percent, au.right_percent, au.continued); });
      },
      [&](const gui::ComposeMood& mood) {
        return edit([&] {
          pad_at_ = {mood.x, mood.y};
          composer_.set_aus(gui::pad_face(*pad_, mood.x, mood.y), mood.continued);
        });
      },
      [&](const gui::ComposeNeutral&) { return edit([&] { composer_.set_aus({}, false); }); },
      [&](const gui::ComposeShown&) { return active || !seen ? Next::Nothing : take(); },
      [&](const gui::ComposeTime& time) {
        std::optional<std::uint32_t> ms;
        if (time.ms) ms = static_cast<std::uint32_t>(*time.ms);
        composer_.set_time(ms, time.continued);
        list_keyframes();
        return Next::Nothing;
      },
      [&](const gui::AddKeyframe&) {
        // Nothing is added that is not seen.
        if (!active && begun()) {
          notices_.say(gui::tr("said.composed_face"), false, now);
          return Next::Show;
        }
        // Where nothing is being composed, what is added is the face that is seen.
        if (!active && !composes() && seen) take();
        return edit([&] { composer_.add(); });
      },
      [&](const gui::ChooseKeyframe& choice) {
        std::optional<std::size_t> keyframe;
        if (choice.keyframe >= 0) keyframe = static_cast<std::size_t>(choice.keyframe);
        return edit([&] { composer_.choose(keyframe); });
      },
      [&](const gui::RemoveKeyframe&) { return edit([&] { composer_.remove(); }); },
      [&](const gui::MoveKeyframe& move) { return edit([&] { composer_.move(move.direction); }); },
      [&](const gui::UndoComposing&) { return edit([&] { composer_.undo(); }); },
      [&](const gui::RedoComposing&) { return edit([&] { composer_.redo(); }); },
      [&](const gui::NewComposition&) {
        if (unsaved()) notices_.say(gui::tr("said.new_stream"), false, now);
        return edit([&] { composer_.begin_anew(); });
      },
      [](const gui::ShowComposed&) { return Next::Show; },
      [&](const gui::PlayComposition&) {
        return composer_.keyframes().empty() ? Next::Nothing : Next::Play;
      },
      [](const gui::SaveComposition&) { return Next::Save; }};
  return std::visit(carry_out, command);
}

void ComposerSession::remake() {
  activations_.resize(mapping_.face.channels.size());
  aus_ = mapping_.apply(composer_.current().aus, activations_);
}

std::vector<gui::AuRow> ComposerSession::au_rows() const {
  return gui::au_rows(composer_.current().aus, aus_, {}, mapping_.recordings);
}

std::vector<float> ComposerSession::face_of(const std::string& aus) const {
  std::vector<float> activations(mapping_.face.channels.size());
  if (const auto frame = protocol::parse_au_set(aus)) mapping_.apply(*frame, activations);
  return activations;
}

void ComposerSession::list_keyframes() {
  const gui::Composer::Keyframes& keyframes = composer_.keyframes();
  if (rows_ != nullptr && listed_ == keyframes) return;
  std::vector<gui::TimelineRow> rows;
  rows.reserve(keyframes.size());
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    if (i < listed_.size() && listed_[i] == keyframes[i]) {
      rows.push_back((*rows_)[i]);
    } else {
      rows.push_back({protocol::format_au_set(keyframes[i]->aus), time_of(*keyframes[i])});
    }
  }
  listed_ = keyframes;
  rows_ = std::make_shared<const std::vector<gui::TimelineRow>>(std::move(rows));
  total_ = total_of(composer_.keyframes());
}

Result<std::string> ComposerSession::load(const std::filesystem::path& file) {
  auto read = read_stream(file);
  if (!read) return read.error();
  gui::Composer::Keyframes keyframes;
  keyframes.reserve(read->keyframes.size());
  for (const playback::Keyframe& timed : read->keyframes) {
    keyframes.push_back(std::make_shared<const gui::ComposedKeyframe>(composed(timed)));
  }
  const bool unsaved = composer_.unsaved();
  composer_.load(std::move(keyframes), file.string(), std::move(read->title));
  pad_at_.reset();
  remake();
  list_keyframes();
  return unsaved ? std::string(gui::tr("said.other_stream")) : std::string();
}

Result<std::string> ComposerSession::save(const std::filesystem::path& file) {
  auto saved = save_stream(composer_.keyframes(), file, composer_.title());
  if (!saved) return saved;
  composer_.saved(file.string());
  list_keyframes();
  return saved;
}

playback::KeyframeList ComposerSession::keyframes() const {
  playback::KeyframeList keyframes;
  for (const auto& keyframe : composer_.keyframes()) {
    std::optional<Milliseconds> time;
    if (keyframe->ms) time = Milliseconds(*keyframe->ms);
    keyframes.add(keyframe->aus, time);
  }
  return keyframes;
}

gui::ComposerView ComposerSession::view(bool active) const {
  gui::ComposerView view;
  view.active = active;
  view.aside = !active && composes();
  const gui::ComposedKeyframe& current = composer_.current();
  view.rows = rows_;
  view.total = total_;
  if (composer_.chosen()) view.chosen = static_cast<int>(*composer_.chosen());
  for (int number = 1; number <= kAuNumberMax; ++number) {
    const auto index = static_cast<std::size_t>(number);
    const int left = percent_of(current.aus.left[index]);
    const int right = percent_of(current.aus.right[index]);
    if (left == 0 && right == 0) continue;
    view.aus.push_back({number, gui::saved_au_name(number, mapping_.recordings), left, right});
  }
  if (current.ms) view.ms = static_cast<int>(*current.ms);
  view.file = composer_.file();
  view.unsaved = composer_.unsaved();
  view.begun = begun();
  view.can_undo = composer_.can_undo();
  view.can_redo = composer_.can_redo();
  view.pad = pad_;
  view.pad_at = pad_at_;
  return view;
}

}  // namespace aucast::app
