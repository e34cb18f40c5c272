#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "client/gui/model/view_text.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"
#include "client/playback/local_playback.h"

namespace aucast::gui {
namespace {

constexpr float kSpeedWidth = 78;
constexpr float kLoopWidth = 76;
constexpr float kRepeatWidth = 66;
/// With less width, the bar has the texts in a line of their own.
constexpr float kRoomy = 560;
/// With less width, speed and loop too.
constexpr float kNarrow = 366;
/// With less width, the bar leaves out what there are keys for.
constexpr float kNarrowest = 200;
/// Height at scale 1, and what the lines of names, and of speed and loop, add to it.
constexpr float kOneLineHeight = 76;
constexpr float kNamesHeight = 24;
constexpr float kLoopHeight = 31;
/// By the arrows of the bar.
constexpr Milliseconds kArrowStep{1'000};
constexpr Milliseconds kFarArrowStep{10'000};
/// More marks than this would be a grey band.
constexpr float kMarksApart = 5;

enum class Icon : std::uint8_t {
  Play,
  Pause,
  KeyframeBack,
  FrameBack,
  FrameOn,
  KeyframeOn,
  Repeat
};

std::string speed_text(int percent) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%gx", percent / 100.0);
  return text.data();
}

/// Drawn, because fonts do not have these signs alike. `middle` and `r`: centre and half height.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float r, unsigned colour) {
  const auto triangle = [&](float x, float direction) {
    const float tip = x + 1.5F * r * direction;
    list.AddTriangleFilled(ImVec2(x, middle.y - r), ImVec2(tip, middle.y), ImVec2(x, middle.y + r),
                           colour);
  };
  const auto bar = [&](float x, float width) {
    list.AddRectFilled(ImVec2(x, middle.y - r), ImVec2(x + width, middle.y + r), colour);
  };
  switch (icon) {
    case Icon::Play:
      triangle(middle.x - 0.6F * r, 1);
      break;
    case Icon::Pause:
      bar(middle.x - 0.8F * r, 0.55F * r);
      bar(middle.x + 0.25F * r, 0.55F * r);
      break;
    case Icon::KeyframeBack:
      bar(middle.x - 1.0F * r, 0.4F * r);
      triangle(middle.x + 1.0F * r, -1);
      break;
    case Icon::KeyframeOn:
      triangle(middle.x - 1.0F * r, 1);
      bar(middle.x + 0.6F * r, 0.4F * r);
      break;
    case Icon::Repeat: {
      // Around, and an arrow's head at the end.
      constexpr float kQuarter = 1.5708F;
      const float around = 0.85F * r;
      list.PathArcTo(middle, around, -0.3F * kQuarter, 3 * kQuarter, 20);
      list.PathStroke(colour, 0, 0.3F * r);
      const ImVec2 head(middle.x, middle.y - around);
      list.AddTriangleFilled(ImVec2(head.x, head.y - 0.6F * r), ImVec2(head.x + 0.8F * r, head.y),
                             ImVec2(head.x, head.y + 0.6F * r), colour);
      break;
    }
    case Icon::FrameBack:
      triangle(middle.x + 0.7F * r, -1);
      break;
    case Icon::FrameOn:
      triangle(middle.x - 0.7F * r, 1);
      break;
  }
}

bool icon_button(const Look& look, const char* id, Icon icon, const std::string& help) {
  const float height = ImGui::GetFrameHeight();
  const bool roomy = ImGui::GetWindowWidth() > kRoomy * look.scale;
  const ImVec2 size(height * (roomy ? 1.5F : 1.0F), height);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::Button(id, size);
  const bool small = icon == Icon::FrameBack || icon == Icon::FrameOn;
  draw_icon(*ImGui::GetWindowDrawList(), icon, ImVec2(at.x + size.x / 2, at.y + size.y / 2),
            (small ? 3.5F : 5.5F) * look.scale, ImGui::GetColorU32(ImGuiCol_Text));
  tip(help);
  ImGui::SameLine(0, roomy ? -1.0F : 4 * look.scale);
  return pressed;
}

/// A mark for each keyframe, as far as there is room, and the part between A and B.
void draw_track(const Look& look, const LocalView& local, ImVec2 from, ImVec2 to, float done) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = 3 * look.scale;
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_ButtonActive), rounding);
  const float width = to.x - from.x;
  const auto x_of = [&](Duration at) {
    return from.x + width * static_cast<float>(seconds(at) / seconds(local.total));
  };
  ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_PlotLines);
  accent.w = 0.6F;
  list.AddRectFilled(from, ImVec2(from.x + width * done, to.y), ImGui::GetColorU32(accent),
                     rounding);
  if (local.total > Duration::zero()) {
    float last = from.x;
    for (const Duration end : *local.ends) {
      const float x = x_of(end);
      if (x - last < kMarksApart * look.scale || end == local.total) continue;
      last = x;
      list.AddRectFilled(ImVec2(x, from.y), ImVec2(x + look.scale, to.y),
                         ImGui::GetColorU32(ImGuiCol_WindowBg));
    }
    if (local.loop_begin && local.loop_end) {
      ImVec4 between = ImGui::ColorConvertU32ToFloat4(colour_of(Tone::Waiting));
      between.w = 0.35F;
      list.AddRectFilled(ImVec2(x_of(*local.loop_begin), from.y),
                         ImVec2(x_of(*local.loop_end), to.y), ImGui::GetColorU32(between));
    }
    for (const auto& mark : {local.loop_begin, local.loop_end}) {
      if (!mark) continue;
      const float x = x_of(*mark);
      list.AddRectFilled(ImVec2(x - look.scale, from.y - 4 * look.scale),
                         ImVec2(x + look.scale, to.y + 4 * look.scale), colour_of(Tone::Waiting));
    }
  }
  const ImVec2 knob(from.x + width * done, (from.y + to.y) / 2);
  list.AddCircleFilled(knob, 7 * look.scale, ImGui::GetColorU32(ImGuiCol_PlotLinesHovered), 24);
}

/// Shows a time above the bar, at the position `at`.
void time_bubble(float at, float top, const std::string& text) {
  const float half = ImGui::CalcTextSize(text.c_str()).x / 2 + ImGui::GetStyle().WindowPadding.x;
  const float x = std::max(half, std::min(at, ImGui::GetIO().DisplaySize.x - half));
  ImGui::SetNextWindowPos(ImVec2(x, top), ImGuiCond_Always, ImVec2(0.5F, 1));
  ImGui::SetTooltip("%s", text.c_str());
}

void seek_bar(const Look& look, const LocalView& local, GuiCommands& commands) {
  const float height = 20 * look.scale;
  const float radius = 7 * look.scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool pressed = ImGui::InvisibleButton("##seek", ImVec2(width, height));
  const bool dragged = held_by_mouse();
  const bool pointed_to = pointed_at();
  const ArrowSteps arrows = arrows_of_item(pressed);
  mark_focus();
  const float inner = std::max(width - 2 * radius, 1.0F);
  const double total = seconds(local.total);
  float done = total > 0 ? static_cast<float>(seconds(local.position) / total) : 1.0F;
  const float pointer = std::clamp((ImGui::GetIO().MousePos.x - at.x - radius) / inner, 0.0F, 1.0F);
  const auto pointed = Duration(static_cast<Duration::rep>(
      static_cast<double>(pointer) * static_cast<double>(local.total.count())));
  if (dragged) {
    done = pointer;
    if (pointed != local.position) commands.push_back(LocalCommand(Seek{pointed}));
  }
  const Duration by = arrows.right * kArrowStep + arrows.up * kFarArrowStep;
  if (by != Duration::zero()) commands.push_back(LocalCommand(SeekBy{by}));
  if (pointed_to || dragged) {
    time_bubble(ImGui::GetIO().MousePos.x, at.y, time_text(pointed));
  } else if (focus_is_here()) {
    const std::string text =
        arrows.held ? time_text(local.position) : std::string(tr("tip.seek_bar"));
    time_bubble(at.x + radius + done * inner, at.y, text);
  }
  const float thick = 3 * look.scale;
  const float middle = at.y + height / 2;
  draw_track(look, local, ImVec2(at.x + radius, middle - thick),
             ImVec2(at.x + radius + inner, middle + thick), done);
}

void pause_button(const Look& look, const LocalView& local, GuiCommands& commands) {
  if (local.playing) {
    if (icon_button(look, "##pause", Icon::Pause, tr("play.pause_tip")))
      commands.push_back(Pause{});
  } else {
    if (icon_button(look, "##play", Icon::Play, tr("play.play_tip"))) commands.push_back(Resume{});
  }
}

void steps(const Look& look, const LocalView& local, GuiCommands& commands) {
  if (icon_button(look, "##kb", Icon::KeyframeBack, tr("play.keyframe_back"))) {
    commands.push_back(LocalCommand(StepKeyframe{-1}));
  }
  if (icon_button(look, "##fb", Icon::FrameBack, tr("play.frame_back", local.step_fps))) {
    commands.push_back(LocalCommand(StepFrame{-1}));
  }
  pause_button(look, local, commands);
  if (icon_button(look, "##fo", Icon::FrameOn, tr("play.frame_on", local.step_fps))) {
    commands.push_back(LocalCommand(StepFrame{1}));
  }
  if (icon_button(look, "##ko", Icon::KeyframeOn, tr("play.keyframe_on"))) {
    commands.push_back(LocalCommand(StepKeyframe{1}));
  }
}

void speed_choice(const Look& look, const LocalView& local, GuiCommands& commands) {
  ImGui::SetNextItemWidth(kSpeedWidth * look.scale);
  if (ImGui::BeginCombo("##speed", speed_text(local.speed_percent).c_str(),
                        ImGuiComboFlags_HeightLarge)) {
    for (const int percent : playback::LocalPlayback::kSpeeds) {
      if (list_item(speed_text(percent), percent == local.speed_percent)) {
        commands.push_back(LocalCommand(SetSpeed{percent}));
      }
    }
    ImGui::EndCombo();
  }
  tip(tr("play.speed_tip"));
}

void loop_button(const Look& look, const LocalView& local, GuiCommands& commands) {
  const char* text = tr("play.loop_a");
  const char* help = tr("play.loop_a_tip");
  if (local.loop_begin) {
    text = local.loop_end ? tr("play.no_loop") : tr("play.loop_b");
    help = local.loop_end ? tr("play.no_loop_tip") : tr("play.loop_b_tip");
  }
  if (ImGui::Button(text, ImVec2(kLoopWidth * look.scale, 0))) {
    commands.push_back(LocalCommand(MarkLoop{}));
  }
  tip(help);
}

void repeat_button(const Look& look, const LocalView& local, bool roomy, GuiCommands& commands) {
  if (local.repeats) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
  }
  const std::string help = tr("play.repeat_tip");
  const bool pressed = roomy
                           ? ImGui::Button(tr("play.repeat"), ImVec2(kRepeatWidth * look.scale, 0))
                           : icon_button(look, "##repeat", Icon::Repeat, help);
  if (local.repeats) ImGui::PopStyleColor();
  if (roomy) tip(help);
  if (pressed) commands.push_back(LocalCommand(ToggleRepeat{}));
}

/// The position, the whole time and the name, which is cut short at the screen position `before`.
void times_and_name(const LocalView& local, float before) {
  ImGui::AlignTextToFramePadding();
  const std::string text = time_text(local.position) + " / " + time_text(local.total);
  ImGui::TextUnformatted(text.c_str());
  ImGui::SameLine();
  fitted_text(local.name, before, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  tip(local.name);
}

/// The bar with everything in one line.
void roomy_bar(const Look& look, const LocalView& local, GuiCommands& commands) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float right = ImGui::GetWindowWidth() - style.WindowPadding.x - 2 * style.ItemSpacing.x -
                      (kSpeedWidth + kLoopWidth + kRepeatWidth) * look.scale;
  steps(look, local, commands);
  times_and_name(local, ImGui::GetWindowPos().x + right - style.ItemSpacing.x);
  ImGui::SameLine(std::max(right, 0.0F));
  speed_choice(look, local, commands);
  ImGui::SameLine();
  loop_button(look, local, commands);
  ImGui::SameLine();
  repeat_button(look, local, true, commands);
}

/// The bar in two or three lines: texts are below the buttons.
void small_bar(const Look& look, const LocalView& local, float width, GuiCommands& commands) {
  const bool whole = width >= kNarrowest * look.scale;
  if (whole) {
    steps(look, local, commands);
  } else {
    pause_button(look, local, commands);
  }
  repeat_button(look, local, false, commands);
  if (width < kNarrow * look.scale) {
    ImGui::NewLine();
  } else {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::SameLine(ImGui::GetWindowWidth() - style.WindowPadding.x - style.ItemSpacing.x -
                    (kSpeedWidth + kLoopWidth) * look.scale);
  }
  if (whole) {
    speed_choice(look, local, commands);
    ImGui::SameLine();
    loop_button(look, local, commands);
  }
  times_and_name(local, ImGui::GetWindowPos().x + width);
}

}  // namespace

float transport_height(const Look& look, const GuiModel& model, float width) {
  if (!model.local.open) return 0;
  float height = kOneLineHeight;
  if (width <= kRoomy * look.scale) height += kNamesHeight;
  if (width >= kNarrowest * look.scale && width < kNarrow * look.scale) height += kLoopHeight;
  return height * look.scale;
}

void transport_bar(const Look& look, const GuiModel& model, float width, GuiCommands& commands) {
  const LocalView& local = model.local;
  if (!local.open) return;
  const float height = transport_height(look, model, width);
  ImGui::SetNextWindowPos(ImVec2(0, ImGui::GetIO().DisplaySize.y - height));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::SetNextWindowBgAlpha(0.82F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12 * look.scale, 8 * look.scale));
  if (ImGui::Begin("transport", nullptr, kFlags)) {
    seek_bar(look, local, commands);
    if (width > kRoomy * look.scale) {
      roomy_bar(look, local, commands);
    } else {
      small_bar(look, local, width, commands);
    }
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace aucast::gui
