#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr std::array<TextKey, 5> kGrounds = {"view.studio", "view.black", "view.grey", "view.white",
                                             "view.none"};

constexpr int kTextStep = 25;

struct LayerLabel {
  TextKey text;
  TextKey tip;
  bool view::Layers::*member;
};
constexpr std::array<LayerLabel, 8> kLayers = {
    {{"view.textured", "tip.textured", &view::Layers::textured},
     {"view.wireframe", "tip.wireframe", &view::Layers::wireframe},
     {"view.polygons", "tip.polygons", &view::Layers::polygons},
     {"view.vertices", "tip.vertices", &view::Layers::vertices},
     {"view.transparent", "tip.transparent", &view::Layers::transparent},
     {"view.muscles", "tip.muscle_lines", &view::Layers::muscles},
     {"view.jaw_tags", "tip.jaw_tags", &view::Layers::jaw_tags},
     {"view.eye_tags", "tip.eye_tags", &view::Layers::eye_tags}}};

void viewpoint(const Look& look, GuiCommands& commands) {
  heading(look, tr("view.viewpoint"), tr("tip.viewpoint"));
  const auto button = [&](TextKey text, int share, view::ViewpointPreset preset) {
    if (wide_button(tr(text), share, 3, true)) commands.push_back(LookFrom{preset});
    tip(tr("tip.look_from"));
  };
  button("view.front", 0, view::ViewpointPreset::Front);
  button("view.three_quarter", 1, view::ViewpointPreset::ThreeQuarter);
  button("view.profile", 2, view::ViewpointPreset::Profile);
  quiet_text(tr("view.mouse"));
}

/// Any combination of layers; transparent needs a surface.
bool layers(const Look& look, view::Layers& shown) {
  heading(look, tr("view.show"), tr("tip.show"));
  bool changed = false;
  const float half = ImGui::GetContentRegionAvail().x / 2;
  for (std::size_t i = 0; i < kLayers.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(half + ImGui::GetStyle().WindowPadding.x);
    const bool useless = kLayers[i].member == &view::Layers::transparent && !shown.surface();
    ImGui::BeginDisabled(useless);
    changed |= ImGui::Checkbox(tr(kLayers[i].text), &(shown.*kLayers[i].member));
    ImGui::EndDisabled();
    tip(tr(kLayers[i].tip));
  }
  return changed;
}

/// Sets layers, background and light to their defaults.
bool usual_view(RenderingSettings& settings) {
  RenderingSettings usual = settings;
  const RenderingSettings first;
  usual.layers = first.layers;
  usual.ground = first.ground;
  usual.light_yaw_deg = first.light_yaw_deg;
  usual.light_pitch_deg = first.light_pitch_deg;
  usual.light_percent = first.light_percent;
  const bool empty = view::format_layers(settings.layers).empty();
  if (!wide_button(tr("view.usual"), 0, 1, usual != settings, empty)) return false;
  settings = usual;
  return true;
}

bool named_slider(const Look& look, const char* name, const char* id, int& value, int least,
                  int most, const char* format) {
  label(look, name, tr("tip.light"));
  const bool changed = slider(id, -1, value, least, most, format, "-200 %");
  tip(tr("tip.light"));
  return changed;
}

bool light(const Look& look, RenderingSettings& settings) {
  heading(look, tr("view.light"));
  bool changed = false;
  label(look, tr("view.background"), tr("tip.background"));
  int ground = static_cast<int>(settings.ground);
  std::array<Word, kGrounds.size()> grounds{};
  std::transform(kGrounds.begin(), kGrounds.end(), grounds.begin(), [](TextKey key) {
    return Word{tr(key), tr("tip.background")};
  });
  grounds.back().tip = tr("view.none_help");
  if (choice("ground", grounds, ground)) {
    settings.ground = static_cast<Ground>(ground);
    changed = true;
  }
  if (settings.ground == Ground::None) {
    quiet_text(tr("view.none_help"));
    toned_text(Tone::Waiting, tr("view.none_video"));
  }
  changed |= named_slider(look, tr("view.light_aside"), "##yaw", settings.light_yaw_deg,
                          -kLightYawMaxDeg, kLightYawMaxDeg, "%d°");
  changed |= named_slider(look, tr("view.light_up"), "##pitch", settings.light_pitch_deg,
                          -kLightPitchMaxDeg, kLightPitchMaxDeg, "%d°");
  changed |= named_slider(look, tr("view.strength"), "##strength", settings.light_percent, 0,
                          kLightPercentMax, "%d %%");
  return changed;
}

bool blinking(const Look& look, RenderingSettings& settings) {
  heading(look, tr("view.blinking"), tr("tip.blinking"));
  bool changed = false;
  label(look, tr("view.blinks"), tr("tip.blinking"));
  changed |= ImGui::Checkbox("##blinking", &settings.blinking);
  tip(tr("tip.blinking"));
  if (!settings.blinking) return changed;
  using Blink = playback::BlinkOptions;
  Blink& blink = settings.blink;
  changed |=
      number_row(look, tr("view.every_ms"), "##interval", blink.interval_ms,
                 {100, 1000, Blink::kIntervalMinMs, Blink::kIntervalMaxMs}, tr("tip.every_ms"));
  changed |=
      number_row(look, tr("view.closing_ms"), "##closing", blink.closing_ms,
                 {25, 250, Blink::kClosingMinMs, Blink::kClosingMaxMs}, tr("tip.closing_ms"));
  changed |= in_between(look, "lids", blink.interpolation);
  int seed = shown_seed(blink.seed);
  if (number_row(look, tr("view.seed"), "##seed", seed, {.most = kSeedShownMax}, tr("tip.seed"))) {
    blink.seed = static_cast<std::uint64_t>(seed);
    changed = true;
  }
  return changed;
}

void pace(const Look& look, const RenderingView& rendering) {
  heading(look, tr("view.pace"), tr("tip.pace"));
  if (rendering.pace.empty()) quiet_text(tr("view.nothing_moved"));
  for (const PaceRow& row : rendering.pace) {
    label(look, row.name.c_str(), tr("tip.pace"));
    ImGui::TextUnformatted(row.value.c_str());
  }
}

void language(const Look& look, const DisplayView& view, DisplaySettings& settings) {
  label(look, tr("view.language"), tr("tip.language"));
  const auto used = std::find_if(view.languages.begin(), view.languages.end(),
                                 [&](const auto& one) { return one.code == view.language; });
  const bool known = used != view.languages.end();
  if (!ImGui::BeginCombo("##language", known ? used->name.c_str() : view.language.c_str())) {
    return tip(tr("tip.language"));
  }
  for (const LanguageEntry& one : view.languages) {
    if (list_item(one.name, one.code == view.language)) settings.language = one.code;
  }
  ImGui::EndCombo();
}

void display(const Look& look, const DisplayView& view, GuiCommands& commands) {
  if (view.languages.empty()) return;
  heading(look, tr("view.window"));
  DisplaySettings settings = view.settings;
  language(look, view, settings);
  label(look, tr("view.text_size"), tr("tip.text_size"));
  static_cast<void>(number_field("##textsize", settings.text_percent,
                                 {kTextStep, 2 * kTextStep, kTextPercentMin, kTextPercentMax},
                                 true));
  tip(tr("tip.text_size"));
  // All has another height when it was changed: the field stays where it can be seen.
  int& drawn =
      *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("drawn"), view.settings.text_percent);
  if (std::exchange(drawn, view.settings.text_percent) != view.settings.text_percent) {
    ImGui::SetScrollHereY();
  }
  if (settings != view.settings) commands.push_back(ChangeDisplay{settings});
}

}  // namespace

void rendering_panel(const Look& look, const GuiModel& model, FaceForm& form,
                     GuiCommands& commands) {
  RenderingSettings settings = model.rendering.settings;
  face_part(look, model, form, commands);
  viewpoint(look, commands);
  bool changed = layers(look, settings.layers);
  changed |= light(look, settings);
  changed |= usual_view(settings);
  changed |= blinking(look, settings);
  if (changed) commands.push_back(ChangeRendering{settings});
  display(look, model.display, commands);
  pace(look, model.rendering);
}

}  // namespace aucast::gui
