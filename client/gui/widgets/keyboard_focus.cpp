#include "client/gui/widgets/keyboard_focus.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "common/text.h"

namespace aucast::gui {
namespace {

constexpr double kPauseEndsWord = 1;  // seconds
constexpr ImGuiItemFlags kSlider = 1 << 20;
/// In the order in which the focus goes through them: the panel, the bar, what lies over the face.
constexpr std::array kWindows = {"panel", "transport", "welcome", "###gallery", "###keys"};

bool pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), true);
}

bool is_down(ImGuiKey key) {
  const ImGuiIO& io = ImGui::GetIO();
  const int index = io.KeyMap[key];
  return index >= 0 && io.KeysDown[index];
}

ImGuiWindow* popup_on_top() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const int open = context.OpenPopupStack.Size;
  return open == 0 ? nullptr : context.OpenPopupStack[open - 1].Window;
}

/// The windows that the focus goes through. While a dialog or a list is open, only that one.
std::vector<ImGuiWindow*> windows() {
  if (ImGuiWindow* const popup = popup_on_top()) return {popup};
  std::vector<ImGuiWindow*> shown;
  for (const char* name : kWindows) {
    ImGuiWindow* const window = ImGui::FindWindowByID(ImHashStr(name));
    if (window != nullptr && window->WasActive) shown.push_back(window);
  }
  return shown;
}

}  // namespace

std::string typed_text() {
  std::string text;
  for (const ImWchar character : ImGui::GetIO().InputQueueCharacters) {
    std::array<char, 5> bytes{};
    if (character >= ' ') text += ImTextCharToUtf8(bytes.data(), character);
  }
  return text;
}

void TypeAhead::take(bool listens, double now) {
  // What was typed while the list was still coming up is looked for once it is there.
  if (now - last_ > kPauseEndsWord) looks_ = false;
  if (!listens) {
    looks_ = false;
    return typed_.clear();
  }
  const std::string typed = typed_text();
  if (typed.empty()) return;
  if (now - last_ > kPauseEndsWord) typed_.clear();
  last_ = now;
  typed_ += lowered(typed);
  looks_ = true;
}

bool TypeAhead::finds(std::string_view label) {
  if (!looks_) return false;
  const std::string whole = lowered(label);
  const std::size_t name = whole.find_first_not_of("0123456789 ");
  const bool named = name != std::string::npos && whole.substr(name).starts_with(typed_);
  if (!named && !whole.starts_with(typed_)) return false;
  looks_ = false;
  return true;
}

TypeAhead& type_ahead() {
  static TypeAhead one;
  return one;
}

void KeyboardFocus::before_frame(bool opens) {
  ImGuiIO& io = ImGui::GetIO();
  ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool clicked =
      std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; });
  if (clicked) hide();
  const bool popup = context.OpenPopupStack.Size > 0;
  // Esc closes one thing at a time, which is not ImGui's way.
  const bool mapped = io.KeyMap[ImGuiKey_Space] >= 0;  // or there is no keyboard
  const bool walks = mapped && (shown_ || popup) && !is_down(ImGuiKey_Escape);
  io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  if (walks) io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  // Its clock is that of the frame before, which may be long ago.
  const double now = ImGui::GetTime() + io.DeltaTime;
  type_ahead().take((popup || opens) && context.ActiveId == 0, now);
}

void KeyboardFocus::begin() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiIO& io = ImGui::GetIO();
  if (moves_) {
    context.NavDisableHighlight = false;
    if (to_slider_) context.NavActivateInputId = 0;
    moves_ = false;
  }
  looks_ = false;
  if (!next_window_.empty()) {
    ImGuiWindow* const next = ImGui::FindWindowByName(next_window_.c_str());
    next_window_.clear();
    if (next != nullptr) {
      ImGui::FocusWindow(next);
      context.NavId = 0;
      look_in(next, direction_ < 0 ? -1 : 0);
    }
  } else if (pressed(ImGuiKey_Tab) && !io.KeyCtrl && !io.KeyAlt) {
    const auto all = windows();
    if (!all.empty()) {
      shown_ = true;
      direction_ = io.KeyShift ? -1 : 1;
      const ImGuiWindow* const now =
          context.NavWindow == nullptr ? nullptr : context.NavWindow->RootWindowForNav;
      const auto found = std::find(all.begin(), all.end(), now);
      if (found == all.end()) {
        ImGui::FocusWindow(all.front());
        context.NavId = 0;
      }
      ImGuiWindow* const in = found == all.end() ? all.front() : *found;
      const bool begins = context.NavId == 0 || !alive_;
      look_in(in, direction_ < 0 ? -1 : begins ? 0 : 1);
    }
  } else if (!context.NavDisableHighlight && pressed(ImGuiKey_Enter) && context.ActiveId == 0) {
    // By itself Enter would only begin to edit.
    context.NavActivateId = context.NavActivateDownId = context.NavActivatePressedId =
        context.NavId;
  }
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);
}

void KeyboardFocus::look_in(ImGuiWindow* window, int direction) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.NavWindow == nullptr) ImGui::FocusWindow(window);
  const ImGuiDir clip = direction < 0 ? ImGuiDir_Up : ImGuiDir_Down;
  ImGui::NavMoveRequestSubmit(
      ImGuiDir_None, clip, ImGuiNavMoveFlags_Tabbing,
      ImGuiScrollFlags_KeepVisibleEdgeX | ImGuiScrollFlags_KeepVisibleEdgeY);
  context.NavTabbingDir = direction;
  context.NavTabbingResultFirst.Clear();
  context.NavTabbingCounter = -1;
  looks_ = true;
  enters_ = context.NavId == 0;
}

void KeyboardFocus::end() {
  ImGui::PopItemFlag();
  ImGuiContext& context = *ImGui::GetCurrentContext();
  alive_ = context.NavIdIsAlive;
  if (!looks_) return;
  const ImGuiNavItemData& nearby = context.NavMoveResultLocal;
  const ImGuiNavItemData& first = context.NavTabbingResultFirst;
  const ImGuiNavItemData& found = nearby.ID != 0 || context.NavTabbingDir != 0 ? nearby : first;
  // Going back from the first ImGui goes around by itself, without having come to an answer.
  const bool around = context.NavTabbingDir < 0 && context.NavMoveScoringItems && !enters_;
  if (found.ID != 0 && !around) {
    moves_ = true;
    to_slider_ = (found.InFlags & kSlider) != 0;
    return;
  }
  // This window is at its end.
  const auto all = windows();
  if (all.empty() || context.NavWindow == nullptr) return;
  const auto now = std::find(all.begin(), all.end(), context.NavWindow->RootWindowForNav);
  const auto count = static_cast<int>(all.size());
  const int at = now == all.end() ? 0 : static_cast<int>(now - all.begin());
  const int next = (at + direction_ + count) % count;
  next_window_ = all[static_cast<std::size_t>(next)]->Name;
  context.NavMoveSubmitted = context.NavMoveScoringItems = false;
  context.NavAnyRequest = context.NavInitRequest;
}

bool KeyboardFocus::hide() {
  ImGui::GetCurrentContext()->NavDisableHighlight = true;
  return std::exchange(shown_, false);
}

ItemsAre::ItemsAre(Kind kind) {
  ImGui::PushItemFlag(kind == Sliders ? kSlider : ImGuiItemFlags_NoTabStop | ImGuiItemFlags_NoNav,
                      true);
}

ItemsAre::~ItemsAre() {
  ImGui::PopItemFlag();
}

ArrowSteps arrows_of_item(bool pressed_now) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiID item = ImGui::GetItemID();
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  bool& held = *storage.GetBoolRef(ImHashStr("held", 0, item));
  const bool was_held = held;
  if (pressed_now) {
    held = used_by_keys() && !held;
  } else if (held && pressed(ImGuiKey_Enter)) {
    held = false;
  }
  held = held && focus_is_here();
  if (!held) return {};
  // Or the arrows would move the focus.
  ImGui::SetActiveID(item, ImGui::GetCurrentWindow());
  context.ActiveIdSource = ImGuiInputSource_Nav;
  context.ActiveIdUsingNavDirMask = ~0U;
  ArrowSteps steps{.held = true};
  const auto by = [](ImGuiKey key) { return pressed(key) ? 1 : 0; };
  steps.right = by(ImGuiKey_RightArrow) - by(ImGuiKey_LeftArrow);
  steps.up = by(ImGuiKey_UpArrow) - by(ImGuiKey_DownArrow);
  bool& stepped = *storage.GetBoolRef(ImHashStr("stepped", 0, item));
  if (!was_held) stepped = false;
  steps.continued = stepped;
  stepped |= steps.right != 0 || steps.up != 0;
  return steps;
}

bool held_by_mouse() {
  return ImGui::IsItemActive() && !used_by_keys();
}

void stay_in_field() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!ImGui::IsItemDeactivated() || !pressed(ImGuiKey_Enter)) return;
  const ImGuiID field = ImGui::GetItemID();
  ImGui::SetActiveID(field, ImGui::GetCurrentWindow());
  context.ActiveIdUsingNavDirMask = ~0U;
  context.ActiveIdUsingNavInputMask = 1U << static_cast<unsigned>(ImGuiNavInput_Cancel);
  context.ActiveIdUsingKeyInputMask = (ImU64{1} << static_cast<unsigned>(ImGuiKey_Home)) |
                                      (ImU64{1} << static_cast<unsigned>(ImGuiKey_End));
  if (ImGuiInputTextState* const text = ImGui::GetInputTextState(field)) text->SelectAll();
}

void enter_field(const char* id) {
  ImGui::GetCurrentContext()->NavActivateInputId = ImGui::GetID(id);
}

void go_to_end_of_field() {
  ImGuiInputTextState* const text = ImGui::GetInputTextState(ImGui::GetItemID());
  if (text == nullptr) return;
  text->Stb.cursor = text->CurLenW;
  text->ClearSelection();
}

void close_popup_by_escape() {
  const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
  const ImGuiWindow* const top = popup_on_top();
  const bool dialog = top == nullptr || (top->Flags & ImGuiWindowFlags_Modal) != 0;
  if (dialog || !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return;
  ImGui::ClosePopupToLevel(open - 1, true);
}

void focus_here(bool shows) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGui::SetFocusID(ImGui::GetItemID(), ImGui::GetCurrentWindow());
  context.NavInitResultId = 0;  // or a window that has just appeared would take its first item
  if (shows) context.NavDisableHighlight = false;
  ImGui::SetScrollHereY();
}

bool focus_is_here() {
  return !ImGui::GetCurrentContext()->NavDisableHighlight && ImGui::IsItemFocused();
}

bool entered_nowhere() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavDisableHighlight && context.ActiveId == 0 && pressed(ImGuiKey_Enter);
}

bool used_by_keys() {
  const ImGuiIO& io = ImGui::GetIO();
  return !io.MouseDown[0] && !io.MouseReleased[0];
}

void mark_focus() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.NavDisableHighlight || !ImGui::IsItemFocused()) return;
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRect(ImVec2(from.x - 2, from.y - 2), ImVec2(to.x + 2, to.y + 2),
                                      ImGui::GetColorU32(ImGuiCol_NavHighlight), 3, 0, 2);
}

}  // namespace aucast::gui
