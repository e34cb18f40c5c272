#include "client/gui/widgets/kept_place.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cfloat>
#include <cmath>
#include <utility>

namespace aucast::gui {
namespace {

/// The rows of this frame, and the window that is being filled; 0: none.
struct Marked {
  ImGuiID window = 0;
  std::vector<RowPlace> rows;
};

Marked& marked() {
  static Marked one;
  return one;
}

/// The height, from the top of all rows, of what the user looks at.
float looked_at(const ImGuiWindow& window) {
  constexpr ImGuiHoveredFlags kFlags = ImGuiHoveredFlags_ChildWindows |
                                       ImGuiHoveredFlags_AllowWhenBlockedByActiveItem |
                                       ImGuiHoveredFlags_AllowWhenBlockedByPopup;
  const bool pointed = ImGui::IsWindowHovered(kFlags);
  return window.Scroll.y + (pointed ? ImGui::GetIO().MousePos.y - window.Pos.y : 0.0F);
}

}  // namespace

void KeptPlace::begin() {
  const ImGuiID window = ImGui::GetCurrentWindow()->ID;
  if (window != window_ || ImGui::IsWindowAppearing()) rows_.clear();
  window_ = window;
  marked() = {window, {}};
}

bool KeptPlace::end() {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  const std::vector<RowPlace> before = std::exchange(rows_, std::move(marked().rows));
  marked() = {};
  // Who scrolls on purpose, as to a row that has the focus, wins.
  if (window.Scroll.y <= 0 || window.ScrollTarget.y < FLT_MAX) return false;
  const float moved = moved_down(before, rows_, looked_at(window));
  if (std::abs(moved) < 1) return false;
  ImGui::SetScrollY(window.Scroll.y + moved);
  return true;
}

void mark_row(std::string_view name) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  if (window.ID != marked().window) return;
  const ImGuiID id = ImHashStr(name.data(), name.size(), window.IDStack.back());
  marked().rows.push_back({id, ImGui::GetCursorPosY()});
}

}  // namespace aucast::gui
