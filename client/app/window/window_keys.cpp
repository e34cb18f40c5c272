#include "client/app/window/window_keys.h"

#include <algorithm>
#include <array>
#include <utility>

namespace aucast::app {
namespace {

constexpr Milliseconds kSeekStep{5'000};
/// Percent.
constexpr int kVolumeStep = 2;

struct KeyRow {
  // One for each alternative: std::variant would try them all, in the groups of GuiCommand too,
  // and take minutes to compile.
  KeyRow(render::Key of, gui::GuiCommand command)
      : key(of), meaning(std::in_place_type<gui::GuiCommand>, std::move(command)) {}
  KeyRow(render::Key of, WindowAct act) : key(of), meaning(std::in_place_type<WindowAct>, act) {}
  KeyRow(render::Key of, SessionAct act) : key(of), meaning(std::in_place_type<SessionAct>, act) {}
  KeyRow(render::Key of, ChangeVolume by)
      : key(of), meaning(std::in_place_type<ChangeVolume>, by) {}

  render::Key key;
  KeyMeaning meaning;
};

using render::Key;

const auto kKeys = std::to_array<KeyRow>({
    {Key::Quit, WindowAct::Leave},
    {Key::Escape, WindowAct::CloseNearest},
    {Key::F, WindowAct::ToggleFullScreen},
    {Key::H, WindowAct::ToggleBare},
    {Key::P, WindowAct::TogglePanel},
    {Key::Question, WindowAct::ToggleKeys},
    {Key::R, gui::LookFrom{view::ViewpointPreset::Front}},
    {Key::S, gui::TakePicture{}},
    {Key::V, gui::ToggleVideo{}},
    {Key::O, gui::Browse{gui::Purpose::PlayStream}},
    {Key::Left, gui::SeekBy{-kSeekStep}},
    {Key::Right, gui::SeekBy{kSeekStep}},
    {Key::Home, gui::Seek{Duration::zero()}},
    {Key::End, gui::Seek{Duration::max()}},
    {Key::PageUp, gui::StepKeyframe{-1}},
    {Key::PageDown, gui::StepKeyframe{1}},
    {Key::Comma, gui::StepFrame{-1}},
    {Key::Period, gui::StepFrame{1}},
    {Key::Slower, gui::ChangeSpeed{-1}},
    {Key::Faster, gui::ChangeSpeed{1}},
    {Key::L, gui::MarkLoop{}},
    {Key::Repeat, gui::ToggleRepeat{}},
    {Key::C, gui::ToggleCaptions{}},
    {Key::Mute, gui::ToggleMute{}},
    {Key::Quieter, ChangeVolume{-kVolumeStep}},
    {Key::Louder, ChangeVolume{kVolumeStep}},
    {Key::Space, &WindowSession::toggle_pause},
    {Key::Undo, &WindowSession::undo},
    {Key::Redo, &WindowSession::redo},
    {Key::Save, &WindowSession::save},
});

}  // namespace

const KeyMeaning* meaning_of(render::Key key) {
  const auto row =
      std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyRow& one) { return one.key == key; });
  return row != kKeys.end() ? &row->meaning : nullptr;
}

}  // namespace aucast::app
