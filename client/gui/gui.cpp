#include "client/gui/gui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "client/gui/keyboard_focus.h"
#include "client/gui/panels.h"
#include "client/gui/texts.h"

namespace aucast::gui {
namespace {

constexpr float kFontSize = 15;
constexpr float kPanelWidth = 380;
/// With large letters it does not take more of the window, unless it does so with small ones.
constexpr float kPanelShareMax = 0.7F;
/// Half of the panel's margin, which is what ImGui lets things use of it.
constexpr float kScrollBar = 8;
constexpr float kTabPadding = 5;
constexpr float kTabGap = 3;

struct FontFiles {
  const char* regular;
  const char* bold;
};
/// Debian's fonts-inter and fonts-dejavu-core.
constexpr std::array<FontFiles, 2> kFonts = {{
    {"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
     "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf"},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
     "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
}};

/// Loads the first pair that is there; else ImGui's own font, which has one weight. Returns the
/// bold one.
ImFont* load_fonts(float scale, const ImVector<ImWchar>& letters) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.GlyphRanges = letters.Data;
  config.OversampleH = 3;
  config.OversampleV = 2;
  for (const FontFiles& files : kFonts) {
    std::error_code ignored;
    if (!std::filesystem::exists(files.regular, ignored)) continue;
    if (!std::filesystem::exists(files.bold, ignored)) continue;
    const float size = kFontSize * scale;
    ImFont* regular = atlas.AddFontFromFileTTF(files.regular, size, &config);
    ImFont* bold = atlas.AddFontFromFileTTF(files.bold, size, &config);
    if (regular != nullptr && bold != nullptr) return bold;
  }
  config.SizePixels = 13 * scale;
  return atlas.AddFontDefault(&config);
}

/// Those of the Latin languages, and what the language in use has besides.
ImVector<ImWchar> letters_of(const DisplayView& display) {
  ImFontGlyphRangesBuilder builder;
  builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
  for (const std::string& text : all_texts()) builder.AddText(text.c_str());
  for (const LanguageEntry& one : display.languages) builder.AddText(one.name.c_str());
  ImVector<ImWchar> letters;
  builder.BuildRanges(&letters);
  return letters;
}

void set_style(float scale) {
  ImGui::GetStyle() = ImGuiStyle();
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 4;
  style.GrabRounding = 3;
  style.PopupRounding = 4;
  style.TabRounding = 4;
  style.ScrollbarRounding = 4;
  style.WindowBorderSize = 0;
  style.WindowPadding = ImVec2(16, 14);
  style.FramePadding = ImVec2(8, 5);
  style.ItemSpacing = ImVec2(8, 6);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.CellPadding = ImVec2(4, 3);
  style.ScrollbarSize = kScrollBar;
  style.GrabMinSize = 9;
  style.ScaleAllSizes(scale);
  ImVec4* colours = style.Colors;
  colours[ImGuiCol_Text] = ImVec4(0.88F, 0.90F, 0.92F, 1);
  colours[ImGuiCol_TextDisabled] = ImVec4(0.48F, 0.51F, 0.55F, 1);
  colours[ImGuiCol_WindowBg] = ImVec4(0.095F, 0.105F, 0.12F, 1);
  colours[ImGuiCol_PopupBg] = ImVec4(0.13F, 0.14F, 0.16F, 0.98F);
  colours[ImGuiCol_Border] = ImVec4(0.26F, 0.28F, 0.31F, 0.6F);
  colours[ImGuiCol_TitleBg] = ImVec4(0.13F, 0.145F, 0.165F, 1);
  colours[ImGuiCol_TitleBgActive] = ImVec4(0.16F, 0.175F, 0.20F, 1);
  colours[ImGuiCol_FrameBg] = ImVec4(0.16F, 0.175F, 0.20F, 1);
  colours[ImGuiCol_FrameBgHovered] = ImVec4(0.20F, 0.22F, 0.25F, 1);
  colours[ImGuiCol_FrameBgActive] = ImVec4(0.23F, 0.25F, 0.29F, 1);
  colours[ImGuiCol_Button] = ImVec4(0.19F, 0.21F, 0.24F, 1);
  colours[ImGuiCol_ButtonHovered] = ImVec4(0.25F, 0.28F, 0.32F, 1);
  colours[ImGuiCol_ButtonActive] = ImVec4(0.30F, 0.34F, 0.39F, 1);
  // Dark enough for the number that is written over it.
  colours[ImGuiCol_SliderGrab] = ImVec4(0.27F, 0.43F, 0.52F, 1);
  colours[ImGuiCol_SliderGrabActive] = ImVec4(0.33F, 0.52F, 0.62F, 1);
  colours[ImGuiCol_CheckMark] = ImVec4(0.48F, 0.72F, 0.84F, 1);
  colours[ImGuiCol_Header] = ImVec4(0.23F, 0.35F, 0.42F, 1);
  colours[ImGuiCol_HeaderHovered] = ImVec4(0.26F, 0.39F, 0.47F, 1);
  colours[ImGuiCol_HeaderActive] = ImVec4(0.29F, 0.44F, 0.53F, 1);
  colours[ImGuiCol_Tab] = ImVec4(0.13F, 0.145F, 0.165F, 1);
  colours[ImGuiCol_TabHovered] = ImVec4(0.26F, 0.39F, 0.47F, 1);
  colours[ImGuiCol_TabActive] = ImVec4(0.23F, 0.35F, 0.42F, 1);
  colours[ImGuiCol_TableHeaderBg] = ImVec4(0.13F, 0.145F, 0.165F, 1);
  colours[ImGuiCol_TableRowBgAlt] = ImVec4(1, 1, 1, 0.02F);
  // The accent, also of what the panels draw themselves.
  colours[ImGuiCol_PlotLines] = ImVec4(0.43F, 0.66F, 0.78F, 1);
  colours[ImGuiCol_PlotLinesHovered] = ImVec4(0.54F, 0.76F, 0.87F, 1);
  // What is written over it is light.
  colours[ImGuiCol_PlotHistogram] = ImVec4(0.23F, 0.35F, 0.42F, 1);
  colours[ImGuiCol_NavHighlight] = ImVec4(0.95F, 0.77F, 0.36F, 1);
  colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.5F);
}

Tone tone_of(const RemoteView& remote) {
  if (remote.stale || !remote.detail.empty()) return Tone::Bad;
  switch (remote.activity) {
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

/// The line that is always there: how playing stands. What there is to be said about it stands over
/// the face, so that no button moves away from under the pointer.
void state_line(const Look& look, const GuiModel& model) {
  const RemoteView& remote = model.remote;
  const float radius = 4.5F * look.scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ImGui::GetTextLineHeight() / 2;
  ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(at.x + radius, middle), radius,
                                              colour_of(tone_of(remote)), 24);
  ImGui::SetCursorScreenPos(ImVec2(at.x + 3.4F * radius, at.y));
  ImGui::PushFont(look.bold);
  ImGui::TextUnformatted(remote.state.c_str());
  ImGui::PopFont();
  // On the same line, so that nothing below moves when a face is edited.
  const std::string beside = model.editor.active     ? tr("panel.your_expression")
                             : model.composer.active ? tr("panel.your_keyframe")
                                                     : remote.keyframe;
  if (!beside.empty()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", beside.c_str());
  }
}

struct KeyHelp {
  TextKey key;
  TextKey meaning;
};
constexpr std::array<KeyHelp, 28> kKeys = {{
    {"keys.space", "keys.does_pause"},       {"keys.left_right", "keys.does_seek"},
    {"keys.home_end", "keys.does_ends"},     {"keys.pages", "keys.does_keyframe"},
    {"keys.frame", "keys.does_frame"},       {"keys.speed", "keys.does_speed"},
    {"keys.loop", "keys.does_loop"},         {"keys.repeat", "keys.does_repeat"},
    {"keys.mute", "keys.does_mute"},         {"keys.volume", "keys.does_volume"},
    {"keys.captions", "keys.does_captions"}, {"keys.open", "keys.does_open"},
    {"keys.tab", "keys.does_focus"},         {"keys.use", "keys.does_use"},
    {"keys.panel", "keys.does_panel"},       {"keys.bare", "keys.does_bare"},
    {"keys.full", "keys.does_full"},         {"keys.picture", "keys.does_picture"},
    {"keys.video", "keys.does_video"},       {"keys.undo", "keys.does_undo"},
    {"keys.save", "keys.does_save"},         {"keys.reset", "keys.does_reset"},
    {"keys.list", "keys.does_list"},         {"keys.escape", "keys.does_close"},
    {"keys.leave", "keys.does_leave"},       {"keys.left_drag", "keys.does_turn"},
    {"keys.right_drag", "keys.does_move"},   {"keys.wheel", "keys.does_zoom"},
}};

/// A column of the list.
struct KeyColumn {
  std::span<const KeyHelp> lines;
  float key = 0;  ///< widths
  float meaning = 0;
  [[nodiscard]] float width() const { return key + meaning; }
};

KeyColumn column_of(std::span<const KeyHelp> lines) {
  KeyColumn column{lines};
  const float gap = ImGui::GetStyle().WindowPadding.x;
  for (const KeyHelp& line : lines) {
    column.key = std::max(column.key, ImGui::CalcTextSize(tr(line.key)).x + gap);
    column.meaning = std::max(column.meaning, ImGui::CalcTextSize(tr(line.meaning)).x);
  }
  return column;
}

void key_help(const KeyColumn& column, std::size_t row, float left) {
  if (row >= column.lines.size()) return;
  const float margin = ImGui::GetStyle().WindowPadding.x;
  if (left > 0) ImGui::SameLine(margin + left);
  ImGui::TextUnformatted(tr(column.lines[row].key));
  ImGui::SameLine(margin + left + column.key);
  toned_line(Tone::Quiet, tr(column.lines[row].meaning));
}

/// In the middle of what the panel leaves free, in two columns where one is too high for the
/// window; what is still too large is scrolled to.
void key_list(const Look& look, float width, bool& shown) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = 10 * look.scale;
  const ImVec2 most(screen.x - 2 * margin, screen.y - 2 * margin);
  const std::span<const KeyHelp> all = kKeys;
  const std::size_t half = (all.size() + 1) / 2;
  const float gap = 1.5F * ImGui::GetStyle().WindowPadding.x;
  const float padding = 2 * ImGui::GetStyle().WindowPadding.x;
  std::array<KeyColumn, 2> columns = {column_of(all.first(half)), column_of(all.subspan(half))};
  const float lines = ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(all.size());
  const bool high = lines + 3 * ImGui::GetFrameHeight() > most.y;
  if (!high || columns[0].width() + columns[1].width() + gap + padding > most.x) {
    columns = {column_of(all), {}};
  }
  const float content =
      columns[0].width() + (columns[1].lines.empty() ? 0 : gap + columns[1].width());
  const bool beside = content + padding <= width;
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), most);
  // By itself it is as wide as what was drawn a frame before, in another language perhaps.
  ImGui::SetNextWindowContentSize(ImVec2(content, 0));
  ImGui::SetNextWindowPos(ImVec2((beside ? width : screen.x) / 2, ImGui::GetIO().DisplaySize.y / 2),
                          ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoSavedSettings;
  const FloatingStyle floating(look);
  if (ImGui::Begin(with_id(tr("keys.title"), "keys").c_str(), &shown, kFlags)) {
    for (std::size_t row = 0; row < columns[0].lines.size(); ++row) {
      key_help(columns[0], row, 0);
      key_help(columns[1], row, columns[0].width() + gap);
    }
  }
  ImGui::End();
}

void leave_question(const Look& look, GuiCommands& commands) {
  const std::string whole_title = with_id(tr("leave.title"), "leave");
  const char* const title = whole_title.c_str();
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  const FloatingStyle floating(look);
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  ImGui::TextUnformatted(tr("leave.why"));
  ImGui::Spacing();
  // The key that asked is not an answer.
  const bool escaped = !ImGui::IsWindowAppearing() &&
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (ImGui::Button(tr("leave.stay")) || escaped) {
    commands.push_back(Leave{false});
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  if (ImGui::Button(tr("leave.leave"))) {
    commands.push_back(Leave{true});
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

struct Tab {
  const char* id;
  TextKey name;
};
constexpr std::array<Tab, 6> kTabs = {{{"play", "tab.play"},
                                       {"expression", "tab.expression"},
                                       {"editor", "tab.editor"},
                                       {"compose", "tab.compose"},
                                       {"view", "tab.view"},
                                       {"camera", "tab.camera"}}};

/// How large the letters of the tabs may be for all names to be whole, at most 1.
float tab_letters(const Look& look) {
  float names = 0;
  for (const Tab& tab : kTabs) names += ImGui::CalcTextSize(tr(tab.name)).x;
  constexpr auto kCount = static_cast<float>(kTabs.size());
  const float rounded = 2 * kCount;  // up, each of them
  const float between = (kCount * 2 * kTabPadding + (kCount - 1) * kTabGap) * look.scale + rounded;
  return std::min(1.0F, (ImGui::GetContentRegionAvail().x - between) / names);
}

/// Tabs narrow enough to stand side by side, as long as it lives.
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
  ImVector<ImWchar> letters;
  KeyboardFocus focus;
  RemoteForm remote;
  ExpressionForm expression;
  EditorForm editor;
  FileForm file;
  NoticeForm notice;
  ComposerForm composer;
  MirrorForm mirror;
  Thumbnails faces;
  GalleryForm gallery;
  bool panel = true;
  bool bare = false;         ///< the user wants the face alone
  bool hidden = false;       ///< panel and bar, until the mouse moves
  bool full_screen = false;  ///< panel and bar lie over the face
  bool keys = false;
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
  letters = letters_of(display);
  ImGui::GetIO().Fonts->Clear();
  look.bold = load_fonts(look.scale, letters);
  ImGui::GetIO().Fonts->Build();
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
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 22 * look.scale);
    if (ImGui::SmallButton("?")) keys = !keys;
    tip(tr("panel.keys_tip"));
    ImGui::Spacing();
    if (begin_tabs(look)) {
      const auto tab = [this](std::size_t which, const auto& contents, bool chosen = false) {
        if (!begin_tab(look, kTabs[which], chosen)) return;
        // As wide whether it scrolls or not: the scroll bar has its place in the margin.
        const float room = ImGui::GetContentRegionAvail().x;
        ImGui::SetNextWindowContentSize(ImVec2(room - kScrollBar / 2 * look.scale, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        const bool visible =
            ImGui::BeginChild("contents", ImVec2(room + kScrollBar * look.scale, 0), false,
                              ImGuiWindowFlags_NavFlattened);
        ImGui::PopStyleVar();  // or what pops up from here would have none either
        if (visible) contents();
        ImGui::EndChild();
        ImGui::EndTabItem();
      };
      tab(0, [&] { remote_panel(look, model, remote, commands); });
      tab(1, [&] { expression_panel(look, model, expression, commands); });
      tab(2, [&] { editor_panel(look, model, editor, commands); });
      tab(3, [&] { composer_panel(look, model, composer, commands); });
      tab(4, [&] { rendering_panel(look, model, faces, commands); });
      // Who begins with the camera sees its tab.
      const bool begins = !std::exchange(drawn, true) && model.mirror.wanted;
      tab(
          5, [&] { mirror_panel(look, model, mirror, commands); }, begins);
      ImGui::EndTabBar();
    }
  }
  ImGui::End();
}

namespace {

/// ImGui itself closes drop-downs by keys only when it is walked through by keys.
void close_popup_by_escape() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const int open = context.OpenPopupStack.Size;
  if (open == 0 || !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return;
  const ImGuiWindow* const top = context.OpenPopupStack[open - 1].Window;
  // A dialog answers for itself.
  if (top == nullptr || (top->Flags & ImGuiWindowFlags_Modal) != 0) return;
  ImGui::ClosePopupToLevel(open - 1, true);
}

}  // namespace

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

void Gui::draw(const GuiModel& model, GuiCommands& commands) {
  state_->focus.before_frame(model.browser.open);
  ImGui::NewFrame();
  state_->focus.begin();
  state_->faces.seen.clear();
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
  captions(state_->look, model, free);
  notices(state_->look, model, free, state_->notice, commands);
  gallery_dialog(state_->look, model, free, state_->gallery, commands);
  file_dialog(state_->look, model, state_->file, commands);
  if (state_->keys) key_list(state_->look, free, state_->keys);
  if (model.asks_to_leave) leave_question(state_->look, commands);
  state_->focus.end();
  ImGui::Render();
}

void Gui::set_camera_texture(std::uintptr_t texture) {
  state_->mirror.texture = texture;
}

Thumbnails& Gui::faces() {
  return state_->faces;
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
  return std::exchange(state_->bare, false);
}

void Gui::set_full_screen(bool full_screen) {
  state_->full_screen = full_screen;
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
  return state_->shows_panel() && !state_->full_screen ? state_->panel_width() : 0;
}

bool Gui::wants_keys() const {
  return ImGui::GetIO().WantTextInput ||
         ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

bool Gui::wants_pointer() const {
  return ImGui::GetIO().WantCaptureMouse;
}

}  // namespace aucast::gui
