#include "client/gui/widgets/style.h"

#include <array>
#include <filesystem>
#include <string>
#include <system_error>

#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

constexpr float kFontSize = 15;

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

/// Loads the first pair that exists, else ImGui's own font, which has one weight. Returns the bold
/// font.
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

/// The letters of the Latin languages, and those that the language in use has besides.
ImVector<ImWchar> letters_of(const DisplayView& display) {
  ImFontGlyphRangesBuilder builder;
  builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesDefault());
  for (const std::string& text : all_texts()) builder.AddText(text.c_str());
  for (const LanguageEntry& one : display.languages) builder.AddText(one.name.c_str());
  ImVector<ImWchar> letters;
  builder.BuildRanges(&letters);
  return letters;
}

}  // namespace

void Fonts::load(float scale, const DisplayView& display) {
  letters_ = letters_of(display);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  bold_ = load_fonts(scale, letters_);
  atlas.Build();
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

}  // namespace aucast::gui
