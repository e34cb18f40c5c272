#include <imgui.h>

#include <algorithm>
#include <array>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr float kMeterHeight = 8;
/// Above these parts of the meter the sound is loud, and too loud.
constexpr float kLoud = 0.75F;
constexpr float kTooLoud = 0.94F;

/// A bar from soft to loud in green, amber and red.
void level_meter(const Look& look, int percent) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = kMeterHeight * look.scale;
  ImGui::Dummy(ImVec2(width, ImGui::GetFrameHeight()));
  at.y += (ImGui::GetFrameHeight() - height) / 2;
  tip(tr("sound.meter_tip"));
  const float rounding = 2 * look.scale;
  list.AddRectFilled(at, ImVec2(at.x + width, at.y + height), ImGui::GetColorU32(ImGuiCol_FrameBg),
                     rounding);
  const float level = static_cast<float>(std::clamp(percent, 0, 100)) / 100;
  struct Part {
    float from;
    float to;
    Tone tone;
  };
  constexpr std::array<Part, 3> kParts = {
      {{0, kLoud, Tone::Good}, {kLoud, kTooLoud, Tone::Waiting}, {kTooLoud, 1, Tone::Bad}}};
  for (const Part& part : kParts) {
    if (level <= part.from) break;
    list.AddRectFilled(ImVec2(at.x + width * part.from, at.y),
                       ImVec2(at.x + width * std::min(level, part.to), at.y + height),
                       colour_of(part.tone), part.from == 0 ? rounding : 0);
  }
}

void device_choice(const Look& look, const SoundView& sound, GuiCommands& commands) {
  label(look, tr("sound.device"), tr("sound.device_tip"));
  const char* shown = sound.device.empty() ? tr("sound.usual_device") : sound.device.c_str();
  const bool open = ImGui::BeginCombo("##device", shown);
  if (!open) return tip(tr("sound.device_tip"));
  if (ImGui::IsWindowAppearing()) commands.push_back(SoundCommand(ListDevices{}));
  if (list_item(tr("sound.usual_device"), sound.device.empty())) {
    commands.push_back(SoundCommand(ChooseDevice{}));
  }
  for (const std::string& device : sound.devices) {
    if (list_item(device, device == sound.device)) {
      commands.push_back(SoundCommand(ChooseDevice{device}));
    }
  }
  ImGui::EndCombo();
}

}  // namespace

void sound_part(const Look& look, const GuiModel& model, GuiCommands& commands) {
  const SoundView& sound = model.sound;
  const bool shows = sound.there || sound.missed || !sound.devices.empty();
  if (shows) heading(look, tr("sound.title"));
  if (sound.missed) {
    label(look, tr("sound.volume"), tr("sound.missed_tip"));
    toned_text(Tone::Waiting, tr("sound.missed"));
    tip(tr("sound.missed_tip"));
  } else if (shows) {
    label(look, tr("sound.volume"), tr("sound.volume_tip"));
    const float mute_width = 64 * look.scale;
    const float width =
        ImGui::GetContentRegionAvail().x - mute_width - ImGui::GetStyle().ItemSpacing.x;
    int volume = sound.volume;
    if (percent_slider("##volume", width, volume)) {
      commands.push_back(SoundCommand(SetVolume{volume}));
    }
    tip(tr("sound.volume_tip"));
    ImGui::SameLine();
    if (ImGui::Button(sound.muted ? tr("sound.unmute") : tr("sound.mute"), ImVec2(mute_width, 0))) {
      commands.push_back(SoundCommand(ToggleMute{}));
    }
    tip(tr("sound.mute_tip"));
    label(look, tr("sound.level"), tr("tip.level_meter"));
    level_meter(look, sound.peak_percent);
  }
  if (shows) device_choice(look, sound, commands);
  if (model.spoken.title.empty() && model.spoken.caption.empty() && model.spoken.shown) return;
  bool shown = model.spoken.shown;
  label(look, tr("sound.captions"), tr("tip.captions"));
  if (ImGui::Checkbox(tr("sound.captions_on"), &shown)) {
    commands.push_back(SoundCommand(ToggleCaptions{}));
  }
  tip(tr("sound.captions_tip"));
}

}  // namespace aucast::gui
