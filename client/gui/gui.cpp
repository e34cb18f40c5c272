#include "client/gui/gui.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>
#include <utility>

#include "client/gui/panels/key_list.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/kept_place.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/style.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr float kPanelWidth = 380;
/// The share of the window that the panel may take with large letters, unless it takes more with
/// small ones.
constexpr float kPanelShareMax = 0.7F;
constexpr float kTabPadding = 5;
constexpr float kTabGap = 3;
/// With smaller letters nobody could read the tabs' names; ImGui then cuts the names short.
constexpr float kTabLettersMin = 0.4F;

Tone tone_of(const PlayingView& playing) {
  if (playing.stale || !playing.detail.empty()) return Tone::Bad;
  switch (playing.activity) {
    case Activity::Playing:
      return Tone::Good;
    case Activity::Connecting:
    case Activity::Paused:
      return Tone::Waiting;
    case Activity::Idle:
    case Activity::Over:
      break;
  }
  return Tone::Quiet;
}

/// The line that is always there: the state of playing. Details are shown over the face, so that no
/// button moves away from under the pointer.
void state_line(const Look& look, const GuiModel& model) {
  const PlayingView& playing = model.playing;
  const float radius = 4.5F * look.scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ImGui::GetTextLineHeight() / 2;
  ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(at.x + radius, middle), radius,
                                              colour_of(tone_of(playing)), 24);
  ImGui::SetCursorScreenPos(ImVec2(at.x + 3.4F * radius, at.y));
  ImGui::PushFont(look.bold);
  ImGui::TextUnformatted(playing.state.c_str());
  ImGui::PopFont();
  // On the same line, so that nothing below moves while a face is edited.
  const bool edits_au = model.editor.active && model.editor.au >= 0;
  const std::string beside = edits_au                ? tr("panel.your_au", model.editor.au)
                             : model.editor.active   ? tr("panel.your_expression")
                             : model.composer.active ? tr("panel.your_keyframe")
                                                     : playing.keyframe;
  if (!beside.empty()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", beside.c_str());
  }
}

/// Says that a video is being recorded, whatever tab is shown.
void recording_mark(const Look& look, const std::string& file, GuiCommands& commands) {
  const float side = ImGui::GetTextLineHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 30 * look.scale - side);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##recording", ImVec2(side, side))) commands.push_back(ToggleVideo{});
  mark_focus();
  ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(at.x + side / 2, at.y + side / 2), side / 3,
                                              colour_of(Tone::Bad), 24);
  tip(tr("play.recording_tip", file));
}

/// Says that a gallery is being made whose dialog was closed, and how far it is.
void gallery_mark(const Look& look, const GalleryView& gallery, GuiCommands& commands) {
  const float side = ImGui::GetTextLineHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 36 * look.scale - 2 * side);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##gallery", ImVec2(side, side))) {
    commands.push_back(GalleryCommand(OpenGallery{}));
  }
  mark_focus();
  tip(tr("panel.gallery_tip", progress_text(gallery)));
  constexpr float kTop = -std::numbers::pi_v<float> / 2;
  constexpr float kAround = 2 * std::numbers::pi_v<float>;
  const float share = gallery.total == 0
                          ? 0.0F
                          : static_cast<float>(gallery.drawn) / static_cast<float>(gallery.total);
  const ImVec2 middle(at.x + side / 2, at.y + side / 2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = 0.4F * side;
  const float thick = 3.5F * look.scale;
  list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_Button), 24, thick);
  list.PathArcTo(middle, radius, kTop, kTop + kAround * std::clamp(share, 0.1F, 1.0F), 24);
  list.PathStroke(colour_of(Tone::Waiting), 0, thick);
}

struct Tab {
  const char* id;
  TextKey name;
  TextKey tip;
};
constexpr Tab kPlayTab{"play", "tab.play", "tip.tab_play"};
constexpr Tab kExpressionTab{"expression", "tab.expression", "tip.tab_expression"};
constexpr Tab kEditorTab{"editor", "tab.editor", "tip.tab_editor"};
constexpr Tab kComposeTab{"compose", "tab.compose", "tip.tab_compose"};
constexpr Tab kViewTab{"view", "tab.view", "tip.tab_view"};
constexpr Tab kCameraTab{"camera", "tab.camera", "tip.tab_camera"};
constexpr std::array kTabs{kPlayTab, kExpressionTab, kEditorTab, kComposeTab, kViewTab, kCameraTab};

/// The scale of the tabs' letters with which all names fit, kTabLettersMin to 1.
float tab_letters(const Look& look) {
  float names = 0;
  for (const Tab& tab : kTabs) names += ImGui::CalcTextSize(tr(tab.name)).x;
  constexpr auto kCount = static_cast<float>(kTabs.size());
  const float rounded = 2 * kCount;  // up, each of them
  const float between = (kCount * 2 * kTabPadding + (kCount - 1) * kTabGap) * look.scale + rounded;
  return std::clamp((ImGui::GetContentRegionAvail().x - between) / names, kTabLettersMin, 1.0F);
}

/// While it lives, tabs are narrow enough to fit side by side.
class TabStyle {
 public:
  explicit TabStyle(const Look& look) {
    ImGui::SetWindowFontScale(tab_letters(look));
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(kTabPadding * look.scale, style.FramePadding.y));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                        ImVec2(kTabGap * look.scale, style.ItemInnerSpacing.y));
  }
  ~TabStyle() {
    ImGui::PopStyleVar(2);
    ImGui::SetWindowFontScale(1);
  }
  TabStyle(const TabStyle&) = delete;
  TabStyle& operator=(const TabStyle&) = delete;
};

bool begin_tabs(const Look& look) {
  const TabStyle narrow(look);
  return ImGui::BeginTabBar("tabs");
}

bool begin_tab(const Look& look, const Tab& tab, bool chosen) {
  const TabStyle narrow(look);
  const auto flags = chosen ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
  return ImGui::BeginTabItem(with_id(tr(tab.name), tab.id).c_str(), nullptr, flags);
}

}  // namespace

struct Gui::State {
  Look look;
  float screen_scale = 1;
  DisplayView display;  ///< what font and style were made for
  Fonts fonts;
  KeyboardFocus focus;
  KeptPlace kept_place;
  RemoteForm remote;
  ExpressionForm expression;
  EditorForm editor;
  FileForm file;
  NoticeForm notice;
  ComposerForm composer;
  MirrorForm mirror;
  FaceForm faces;
  GalleryForm gallery;
  bool panel = true;
  bool bare = false;    ///< the user wants the face alone
  bool hidden = false;  ///< panel and bar, until the mouse moves
  bool keys = false;
  bool asks = false;        ///< a dialog is there, or comes in the next frame
  bool rows_moved = false;  ///< in the last frame
  /// The last one; that panels were hidden changes nothing.
  std::string_view tab_seen = kPlayTab.id;
  bool drawn = false;  ///< once at least

  [[nodiscard]] bool shows_bar() const { return !bare && !hidden; }
  [[nodiscard]] bool shows_panel() const { return panel && shows_bar(); }
  [[nodiscard]] float panel_width() const {
    const float window = ImGui::GetIO().DisplaySize.x;
    const float usual = std::min(kPanelWidth * screen_scale, window);
    return std::min(kPanelWidth * look.scale, std::max(usual, kPanelShareMax * window));
  }
  void make_style();
  void side_panel(const GuiModel& model, GuiCommands& commands);
};

void Gui::State::make_style() {
  look.scale = screen_scale * static_cast<float>(display.settings.text_percent) / 100;
  fonts.load(look.scale, display);
  look.bold = fonts.bold();
  set_style(look.scale);
}

void Gui::State::side_panel(const GuiModel& model, GuiCommands& commands) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float width = panel_width();
  ImGui::SetNextWindowPos(ImVec2(size.x - width, 0));
  ImGui::SetNextWindowSize(ImVec2(width, size.y));
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("panel", nullptr, kFlags)) {
    state_line(look, model);
    if (!model.video.recording.empty()) recording_mark(look, model.video.recording, commands);
    if (model.gallery.running && !model.gallery.open) {
      gallery_mark(look, model.gallery, commands);
    }
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 22 * look.scale);
    if (ImGui::SmallButton("?")) keys = !keys;
    tip(tr("panel.keys_tip"));
    ImGui::Spacing();
    if (begin_tabs(look)) {
      const auto tab = [this](const Tab& which, const auto& contents, bool chosen = false) {
        const bool shows = begin_tab(look, which, chosen);
        tip(tr(which.tip));
        if (!shows) return;
        // As wide whether it scrolls or not: the scroll bar has its place in the margin.
        const float room = ImGui::GetContentRegionAvail().x;
        ImGui::SetNextWindowContentSize(ImVec2(room - kScrollBar / 2 * look.scale, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        const bool visible =
            ImGui::BeginChild("contents", ImVec2(room + kScrollBar * look.scale, 0), false,
                              ImGuiWindowFlags_NavFlattened);
        ImGui::PopStyleVar();  // or what pops up from here would have none either
        if (visible) {
          editor.comes = std::exchange(tab_seen, which.id) != which.id;
          kept_place.begin();
          contents();
          rows_moved = kept_place.end();
        }
        ImGui::EndChild();
        ImGui::EndTabItem();
      };
      tab(kPlayTab, [&] { remote_panel(look, model, remote, commands); });
      tab(kExpressionTab, [&] { expression_panel(look, model, expression, commands); });
      tab(kEditorTab, [&] { editor_panel(look, model, editor, commands); });
      tab(kComposeTab, [&] { composer_panel(look, model, composer, commands); });
      tab(kViewTab, [&] { rendering_panel(look, model, faces, commands); });
      // Who begins with the camera sees its tab.
      const bool begins = !std::exchange(drawn, true) && model.mirror.wanted;
      tab(
          kCameraTab, [&] { mirror_panel(look, model, mirror, commands); }, begins);
      ImGui::EndTabBar();
    }
  }
  ImGui::End();
}

Gui::Gui(float scale) : state_(std::make_unique<State>()) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  state_->screen_scale = scale;
  state_->make_style();
}

Gui::~Gui() {
  ImGui::DestroyContext();
}

bool Gui::prepare(const DisplayView& display) {
  DisplayView& made_for = state_->display;
  const bool alike = made_for.language == display.language &&
                     made_for.languages == display.languages &&
                     made_for.settings.text_percent == display.settings.text_percent;
  if (alike) return false;
  made_for = display;
  state_->make_style();
  return true;
}

void Gui::expect(const GuiModel& model) {
  state_->asks = model.browser.open || model.asks_to_leave;
}

void Gui::draw(const GuiModel& model, GuiCommands& commands) {
  state_->rows_moved = false;
  state_->focus.before_frame(model.browser.open);
  ImGui::NewFrame();
  state_->focus.begin();
  state_->faces.pictures.seen.clear();
  state_->composer.pictures.seen.clear();
  close_popup_by_escape();
  if (state_->hidden) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  if (state_->shows_panel()) state_->side_panel(model, commands);
  const float panel = state_->shows_panel() ? state_->panel_width() : 0;
  const float free = ImGui::GetIO().DisplaySize.x - panel;
  if (state_->shows_bar()) {
    transport_bar(state_->look, model, free, commands);
    welcome(state_->look, model, free, commands);
  }
  const float bar = state_->shows_bar() ? transport_height(state_->look, model, free) : 0;
  state_->notice.other_server |= std::exchange(state_->remote.renamed, false);
  const float taken = notices(state_->look, model, free, bar, state_->notice, commands);
  captions(state_->look, model, free, taken);
  gallery_dialog(state_->look, model, free, state_->gallery, commands);
  // Of two questions side by side ImGui would show none.
  if (!model.asks_to_leave) {
    file_dialog(state_->look, model, state_->file, commands);
    face_dialog(state_->look, model, state_->faces, commands);
  }
  if (state_->keys) key_list(state_->look, free, state_->keys);
  if (model.asks_to_leave) leave_dialog(state_->look, model, commands);
  state_->focus.end();
  ImGui::Render();
}

bool Gui::rows_moved() const {
  return state_->rows_moved;
}

void Gui::set_camera_texture(std::uintptr_t texture) {
  state_->mirror.texture = texture;
}

Thumbnails& Gui::faces() {
  return state_->faces.pictures;
}

Thumbnails& Gui::keyframes() {
  return state_->composer.pictures;
}

void Gui::toggle_panel() {
  state_->panel = !state_->shows_panel();
  state_->bare = false;
}

void Gui::toggle_bare() {
  state_->bare = !state_->bare;
}

bool Gui::end_bare() {
  return std::exchange(state_->bare, false) && !state_->hidden;
}

bool Gui::show_panel() {
  return !std::exchange(state_->panel, true) && !state_->hidden;
}

void Gui::set_hidden(bool hidden) {
  state_->hidden = hidden;
}

void Gui::toggle_keys() {
  state_->keys = !state_->keys;
}

bool Gui::focus_shown() const {
  return state_->focus.shown();
}

bool Gui::hide_focus() {
  return state_->focus.hide();
}

bool Gui::close_keys() {
  return std::exchange(state_->keys, false);
}

bool Gui::close_notice() {
  NoticeForm& form = state_->notice;
  if (form.shown.empty()) return false;
  form.closed = std::exchange(form.shown, {});
  return true;
}

float Gui::covered_width() const {
  return state_->shows_panel() ? state_->panel_width() : 0;
}

bool Gui::wants_keys() const {
  return ImGui::GetIO().WantTextInput || state_->asks ||
         ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool Gui::wants_pointer() const {
  return ImGui::GetIO().WantCaptureMouse;
}

}  // namespace aucast::gui
