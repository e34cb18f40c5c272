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

namespace aucast::gui {
namespace {

constexpr float kRow = 24;
constexpr float kNumberWidth = 28;
constexpr float kValueWidth = 34;
/// More of them begin folded: the table of AUs is below them.
constexpr std::size_t kCurvesOpen = 8;
constexpr float kNameSize = 0.85F;
/// How much of a line its name covers.
constexpr float kNameGround = 0.7F;

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

/// The name of an AU over its line, which is dimmed there and still to be followed.
void name_over(const Look& look, int number, ImVec2 from, ImVec2 to) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string name = au_name(number);
  const float size = kNameSize * ImGui::GetFontSize();
  const float width = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, name.c_str()).x;
  const float inset = 4 * look.scale;
  const ImVec2 end(std::min(from.x + width + 2 * inset, to.x), to.y);
  list.AddRectFilled(from, end, ImGui::GetColorU32(ImGuiCol_FrameBg, kNameGround));
  list.AddText(ImGui::GetFont(), size, ImVec2(from.x + inset, (from.y + to.y - size) / 2),
               ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
}

/// The heading, a part to fold; returns whether it is open.
bool curves_heading(const Look& look, const AuCurves& curves, bool another) {
  ImGui::Dummy(ImVec2(0, 5 * look.scale));
  if (another) ImGui::SetNextItemOpen(curves.size() <= kCurvesOpen);
  ImGui::PushFont(look.bold);
  const std::string title = tr("curves.title", curves.size());
  const bool open =
      ImGui::TreeNodeEx(with_id(title.c_str(), "fold").c_str(),
                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
  ImGui::PopFont();
  return open;
}

}  // namespace

void curves_part(const Look& look, const GuiModel& model, CurvesForm& form, GuiCommands& commands) {
  const LocalView& local = model.local;
  if (!local.open || local.curves == nullptr || local.curves->empty()) return;
  if (!curves_heading(look, *local.curves,
                      std::exchange(form.shown, local.curves) != local.curves)) {
    return;
  }
  quiet_text(tr("curves.help"));
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float left = corner.x + kNumberWidth * look.scale;
  const float right = corner.x + width - kValueWidth * look.scale;
  const float height = kRow * look.scale;
  const auto rows = static_cast<float>(local.curves->size());
  make_outlines(local, static_cast<std::size_t>(std::max(2.0F, right - left)), form);
  const bool pressed = ImGui::InvisibleButton("##curves", ImVec2(width, rows * height));
  const bool hovered = pointed_at();
  const ArrowSteps arrows = arrows_of_item(pressed);
  mark_focus();
  if (focus_is_here() && !arrows.held) tip(tr("tip.curves"));
  if (arrows.right != 0) commands.push_back(LocalCommand(StepFrame{arrows.right}));
  form.row = std::clamp(form.row - arrows.up, 0, static_cast<int>(local.curves->size()) - 1);
  const float pointer = std::clamp((ImGui::GetIO().MousePos.x - left) / (right - left), 0.0F, 1.0F);
  const Duration pointed(
      std::llround(static_cast<double>(pointer) * static_cast<double>(local.total.count())));
  const Duration place = hovered ? pointed : local.position;
  if (pressed && !used_by_keys()) commands.push_back(LocalCommand(Seek{pointed}));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float y = corner.y;
  const float text = (height - ImGui::GetTextLineHeight()) / 2;
  int below = -1;
  const float row_top = corner.y + height * static_cast<float>(form.row);
  for (std::size_t i = 0; i < local.curves->size(); ++i, y += height) {
    const AuCurve& curve = (*local.curves)[i];
    const ImVec2 from(left, y + look.scale);
    const ImVec2 to(right, y + height - look.scale);
    if (!ImGui::IsRectVisible(from, to)) continue;
    if (hovered && ImGui::GetIO().MousePos.y >= y && ImGui::GetIO().MousePos.y < y + height) {
      below = curve.number;
    }
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg));
    line_of(look, form.outlines[i], from, to);
    name_over(look, curve.number, from, to);
    list.AddText(ImVec2(corner.x, y + text), ImGui::GetColorU32(ImGuiCol_Text),
                 std::to_string(curve.number).c_str());
    const std::string value =
        std::to_string(std::lround(100 * value_at(curve, *local.ends, place)));
    list.AddText(ImVec2(corner.x + width - ImGui::CalcTextSize(value.c_str()).x, y + text),
                 ImGui::GetColorU32(ImGuiCol_Text), value.c_str());
  }
  const auto line_at = [&](Duration at, unsigned colour) {
    const double part = seconds(at) / std::max(1e-9, seconds(local.total));
    const float x = left + (right - left) * static_cast<float>(part);
    list.AddLine(ImVec2(x, corner.y), ImVec2(x, y), colour, look.scale);
  };
  line_at(local.position, colour_of(Tone::Waiting));
  const auto tell = [&](int number, Duration at, float x, float top) {
    tip_at(
        x, top,
        (number < 0 ? std::string() : au_name(number)) + "\n" + seconds_text(seconds(at)) + " s");
  };
  if (arrows.held) {
    if (arrows.up != 0) ImGui::SetScrollFromPosY(row_top - ImGui::GetWindowPos().y, 0.5F);
    list.AddRect(ImVec2(left, row_top), ImVec2(right, row_top + height), colour_of(Tone::Waiting),
                 0, 0, look.scale);
    const int number = (*local.curves)[static_cast<std::size_t>(form.row)].number;
    return tell(number, local.position, left, row_top);
  }
  if (!hovered) return;
  line_at(pointed, ImGui::GetColorU32(ImGuiCol_Text));
  tell(below, pointed, ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
}

}  // namespace aucast::gui
