#include "client/gui/widgets/tips.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace aucast::gui {
namespace {

/// In units of the font size.
constexpr float kTipWidth = 26;
constexpr float kTipWidthLeast = 8;
/// A window with fewer rows than this is a bar.
constexpr float kBarRows = 5;

struct TipPlace {
  ImVec2 at;
  float width = 0;  ///< of its lines
};

/// Beside the window that the item is in, so that the rows above and below can be seen; if there is
/// no room, above the row above. For a bar, above the bar.
TipPlace place_of_tip(const std::string& text, const ImRect& item) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImRect window = ImGui::GetCurrentWindow()->RootWindow->Rect();
  const float gap = style.ItemSpacing.x;
  const float wanted = kTipWidth * ImGui::GetFontSize();
  const auto size_at = [&](float width) {
    const ImVec2 lines = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
    return ImVec2(lines.x + 2 * style.WindowPadding.x, lines.y + 2 * style.WindowPadding.y);
  };
  const float left = window.Min.x;
  const float right = screen.x - window.Max.x;
  const float room = std::max(left, right) - 2 * gap - 2 * style.WindowPadding.x;
  const bool bar = window.GetHeight() < kBarRows * ImGui::GetFrameHeightWithSpacing();
  // What is at the right of a bar is the panel.
  const float end = bar ? window.Max.x : screen.x;
  TipPlace place{item.Min, std::min(wanted, end - 2 * (gap + style.WindowPadding.x))};
  if (!bar && room >= kTipWidthLeast * ImGui::GetFontSize()) {
    place.width = std::min(wanted, room);
    // Where there is enough at both sides it stands at the left, over the face.
    const bool at_left = left >= right || left - 2 * gap >= size_at(place.width).x;
    place.at.x = at_left ? left - gap - size_at(place.width).x : window.Max.x + gap;
  } else {
    const float above = bar ? window.Min.y : item.Min.y - ImGui::GetFrameHeightWithSpacing();
    const float below = item.Max.y + ImGui::GetFrameHeightWithSpacing();
    const float height = size_at(place.width).y + gap;
    place.at.y = above >= height ? above - height : below + gap;
  }
  const ImVec2 size = size_at(place.width);
  place.at.x = std::max(gap, std::min(place.at.x, end - gap - size.x));
  place.at.y = std::max(gap, std::min(place.at.y, screen.y - gap - size.y));
  return place;
}

void tip_beside(const std::string& text, const ImRect& item) {
  const TipPlace place = place_of_tip(text, item);
  ImGui::SetNextWindowPos(place.at);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + place.width);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

/// Whether the last item was used since the pointer or the focus came to it. The user then knows
/// it, and its tip should not hide what it opened.
bool used_since_pointed_at(bool pointed) {
  const ImGuiID item = ImGui::GetItemID();
  if (item == 0) return false;
  bool& used = *ImGui::GetStateStorage()->GetBoolRef(ImHashStr("used", 0, item));
  used = pointed && (used || ImGui::IsItemActivated());
  return used;
}

}  // namespace

void tip(const std::string& text, bool also_disabled) {
  const ImGuiHoveredFlags flags =
      also_disabled ? ImGuiHoveredFlags_AllowWhenDisabled : ImGuiHoveredFlags_None;
  const bool pointed = ImGui::IsItemHovered(flags);
  if (text.empty() || used_since_pointed_at(pointed) || !pointed) return;
  tip_of_last(text);
}

void tip_of_last(const std::string& text) {
  tip_beside(text, ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()));
}

void tip_at(float x, float y, const std::string& text) {
  tip_beside(text, ImRect(x, y, x, y));
}

}  // namespace aucast::gui
