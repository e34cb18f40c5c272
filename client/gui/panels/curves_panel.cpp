#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "client/gui/model/view_text.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/keyboard_focus.h"
#include "client/gui/widgets/tips.h"
#include "common/action_unit.h"

namespace aucast::gui {
namespace {

constexpr float kCurve = 24;
constexpr float kNumberWidth = 28;
constexpr float kValueWidth = 34;
/// More of them begin folded: the table of AUs is below them.
constexpr std::size_t kCurvesOpen = 8;
constexpr float kNameSize = 0.85F;

/// What is drawn of the curves stays the same until another stream is opened.
void make_outlines(const LocalView& local, std::size_t columns, CurvesForm& form) {
  if (form.of == local.curves && form.columns == columns) return;
  form.of = local.curves;
  form.columns = columns;
  form.outlines.clear();
  for (const AuCurve& curve : *local.curves) {
    form.outlines.push_back(outline_of(curve, *local.ends, columns));
  }
}

void line_of(const Look& look, const std::vector<float>& outline, ImVec2 from, ImVec2 to) {
  std::vector<ImVec2> points;
  points.reserve(outline.size());
  const float inset = 3 * look.scale;
  const float bottom = to.y - inset;
  const float step = (to.x - from.x) / static_cast<float>(outline.size() - 1);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    points.emplace_back(from.x + step * static_cast<float>(i),
                        bottom - outline[i] * (bottom - from.y - inset));
  }
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                          ImGui::GetColorU32(ImGuiCol_PlotLines), 0,
                                          1.5F * look.scale);
}

float name_height() {
  return kNameSize * ImGui::GetFontSize();
}

/// The heading, a part to fold; returns whether it is open.
bool curves_heading(const Look& look, const AuCurves& curves, bool another) {
  ImGui::Dummy(ImVec2(0, 5 * look.scale));
  if (another) ImGui::SetNextItemOpen(curves.size() <= kCurvesOpen);
  ImGui::PushFont(look.bold);
  const std::string title = tr("curves.title", curves.size());
  const bool open = foldable(with_id(title.c_str(), "fold").c_str());
  ImGui::PopFont();
  return open;
}

/// Where the rows of the curves are, on the screen.
struct Rows {
  ImVec2 corner;   ///< top left of the first
  float left = 0;  ///< where the lines begin, and end
  float right = 0;
  float end = 0;     ///< the right edge of the values
  float height = 0;  ///< of one
  std::size_t count = 0;

  [[nodiscard]] float top(std::size_t row) const {
    return corner.y + height * static_cast<float>(row);
  }
  [[nodiscard]] float x_of(Duration place, Duration total) const {
    const double part = seconds(place) / std::max(1e-9, seconds(total));
    return left + (right - left) * static_cast<float>(part);
  }
  [[nodiscard]] Duration place_of(float x, Duration total) const {
    const float part = std::clamp((x - left) / std::max(1.0F, right - left), 0.0F, 1.0F);
    return Duration(std::llround(static_cast<double>(part) * static_cast<double>(total.count())));
  }
};

Rows rows_here(const Look& look, std::size_t count) {
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  return {.corner = corner,
          .left = corner.x + kNumberWidth * look.scale,
          .right = corner.x + width - kValueWidth * look.scale,
          .end = corner.x + width,
          .height = name_height() + kCurve * look.scale,
          .count = count};
}

/// Draws the curves that are seen, each with its number, its name above it and its value at
/// `place`.
void draw_rows(const Look& look, const GuiModel& model, const CurvesForm& form, const Rows& rows,
               Duration place) {
  const LocalView& local = model.local;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
  for (std::size_t i = 0; i < rows.count; ++i) {
    const AuCurve& curve = (*local.curves)[i];
    const ImVec2 corner(rows.left, rows.top(i));
    const ImVec2 from(rows.left, corner.y + name_height() + look.scale);
    const ImVec2 to(rows.right, rows.top(i + 1) - look.scale);
    if (!ImGui::IsRectVisible(corner, to)) continue;
    list.AddText(ImGui::GetFont(), name_height(), corner, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                 au_name_of(model, curve.number).c_str());
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg));
    line_of(look, form.outlines[i], from, to);
    const float y = (from.y + to.y - ImGui::GetTextLineHeight()) / 2;
    list.AddText(ImVec2(rows.corner.x, y), colour, std::to_string(curve.number).c_str());
    const std::string value = std::to_string(percent_of(value_at(curve, *local.ends, place)));
    list.AddText(ImVec2(rows.end - ImGui::CalcTextSize(value.c_str()).x, y), colour, value.c_str());
  }
}

/// A line through all rows.
void draw_place(const Look& look, const Rows& rows, float x, unsigned colour) {
  ImGui::GetWindowDrawList()->AddLine(ImVec2(x, rows.corner.y), ImVec2(x, rows.top(rows.count)),
                                      colour, look.scale);
}

/// Says at a point of the screen which AU is there, and which time.
void tell(const std::string& name, Duration place, float x, float y) {
  tip_at(x, y, name + "\n" + seconds_text(seconds(place)) + " s");
}

}  // namespace

void curves_part(const Look& look, const GuiModel& model, CurvesForm& form, GuiCommands& commands) {
  const LocalView& local = model.local;
  if (!local.open || local.curves == nullptr || local.curves->empty()) return;
  const AuCurves& curves = *local.curves;
  if (!curves_heading(look, curves, std::exchange(form.shown, local.curves) != local.curves))
    return;
  quiet_text(tr("curves.help"));
  const Rows rows = rows_here(look, curves.size());
  make_outlines(local, static_cast<std::size_t>(std::max(2.0F, rows.right - rows.left)), form);
  const bool pressed = ImGui::InvisibleButton(
      "##curves", ImVec2(rows.end - rows.corner.x, rows.top(rows.count) - rows.corner.y));
  const bool hovered = pointed_at();
  const ArrowSteps arrows = arrows_of_item(pressed);
  mark_focus();
  if (focus_is_here() && !arrows.held) tip(tr("tip.curves"));
  if (arrows.right != 0) commands.push_back(LocalCommand(StepFrame{arrows.right}));
  form.row = std::clamp(form.row - arrows.up, 0, static_cast<int>(curves.size()) - 1);
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const Duration pointed = rows.place_of(pointer.x, local.total);
  if (pressed && !used_by_keys()) commands.push_back(LocalCommand(Seek{pointed}));

  draw_rows(look, model, form, rows, hovered ? pointed : local.position);
  draw_place(look, rows, rows.x_of(local.position, local.total), colour_of(Tone::Waiting));
  if (arrows.held) {
    const auto row = static_cast<std::size_t>(form.row);
    const float top = rows.top(row);
    if (arrows.up != 0) ImGui::SetScrollFromPosY(top - ImGui::GetWindowPos().y, 0.5F);
    ImGui::GetWindowDrawList()->AddRect(ImVec2(rows.left, top),
                                        ImVec2(rows.right, rows.top(row + 1)),
                                        colour_of(Tone::Waiting), 0, 0, look.scale);
    tell(au_name_of(model, curves[row].number), local.position, rows.left, top);
  } else if (hovered) {
    draw_place(look, rows, rows.x_of(pointed, local.total), ImGui::GetColorU32(ImGuiCol_Text));
    const auto row = static_cast<std::size_t>((pointer.y - rows.corner.y) / rows.height);
    tell(row < rows.count ? au_name_of(model, curves[row].number) : "", pointed, pointer.x,
         pointer.y);
  }
}

}  // namespace aucast::gui
