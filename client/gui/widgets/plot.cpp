#include "client/gui/widgets/plot.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <vector>

#include "client/gui/model/label_places.h"
#include "client/gui/widgets/keyboard_focus.h"

namespace aucast::gui {
namespace {

constexpr int kMarkers = 6;
constexpr float kMarkerRadius = 3.2F;
/// The distance in samples from one marker of a line to the next; those of other lines lie in
/// between.
constexpr std::size_t kMarkerEvery = 24;

/// Draws the sign of a line: each of the few lines has its own.
void draw_marker(int marker, const ImVec2& at, float r, unsigned colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto place = [&](float x, float y) { return ImVec2(at.x + x * r, at.y + y * r); };
  const float thick = 0.45F * r;
  switch (marker % kMarkers) {
    case 0:
      return list.AddCircleFilled(at, r, colour, 12);
    case 1:
      return list.AddRectFilled(place(-0.9F, -0.9F), place(0.9F, 0.9F), colour);
    case 2:
      return list.AddTriangleFilled(place(0, -1.2F), place(1.1F, 0.9F), place(-1.1F, 0.9F), colour);
    case 3:
      list.AddLine(place(-1, -1), place(1, 1), colour, thick);
      return list.AddLine(place(-1, 1), place(1, -1), colour, thick);
    case 4:
      return list.AddQuadFilled(place(0, -1.3F), place(1.3F, 0), place(0, 1.3F), place(-1.3F, 0),
                                colour);
    default:
      return list.AddCircle(at, r, colour, 12, thick);
  }
}

/// Writes labels beside the ends of the lines, in their colours, kept apart from each other.
void line_labels(const Look& look, std::span<const PlotLine> lines, float x, float top,
                 float bottom) {
  const float row = ImGui::GetTextLineHeight();
  std::vector<float> wanted;
  for (const PlotLine& line : lines) {
    const float last = line.values->empty() ? 0.0F : std::clamp(line.values->back(), 0.0F, 1.0F);
    wanted.push_back(bottom - last * (bottom - top) - row / 2);
  }
  const std::vector<float> places = label_places(wanted, row, top, bottom - row);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    float left = x;
    if (lines[i].marker >= 0) {
      const float r = kMarkerRadius * look.scale;
      draw_marker(lines[i].marker, ImVec2(x + r, places[i] + row / 2), r, lines[i].colour);
      left += 3 * r;
    }
    ImGui::GetWindowDrawList()->AddText(ImVec2(left, places[i]), lines[i].colour,
                                        lines[i].label.c_str());
  }
}

/// Writes what the edges of a plot stand for, small and grey.
void scale_texts(const PlotScale& scale, ImVec2 from, ImVec2 to, float mark_y) {
  const float size = 0.8F * ImGui::GetFontSize();
  const auto write = [&](float x, float y, const std::string& text) {
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size, ImVec2(x, y),
                                        ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
  };
  write(from.x, from.y, scale.top);
  write(from.x, mark_y - size, scale.mark_text);
  write(from.x, to.y - size, scale.begin);
  const float width = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, scale.end.c_str()).x;
  write(to.x - width, to.y - size, scale.end);
}

}  // namespace

bool plot(const Look& look, std::span<const PlotLine> lines, float height, const PlotScale& scale) {
  constexpr float kSamplesWide = 121;  // half a minute, four a second
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, height);
  const ImVec2 to(from.x + size.x, from.y + size.y);
  ImGui::PushID(static_cast<int>(ImGui::GetCursorPosY()));  // scrolled it is the same one
  const bool clicked = ImGui::InvisibleButton("##plot", size);
  mark_focus();
  ImGui::PopID();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg),
                      ImGui::GetStyle().FrameRounding);
  float labels = 0;
  for (const PlotLine& line : lines) {
    const float sign = line.marker >= 0 ? 3 * kMarkerRadius * look.scale : 0.0F;
    labels = std::max(labels, ImGui::CalcTextSize(line.label.c_str()).x + sign);
  }
  const float inset = 3 * look.scale;
  if (labels > 0) labels += 2 * inset;
  const float end = to.x - inset - labels;
  const float bottom = to.y - inset;
  const float reach = size.y - 2 * inset;
  const float mark_y = bottom - scale.mark * reach;
  if (scale.mark > 0) {
    list->AddLine(ImVec2(from.x, mark_y), ImVec2(to.x, mark_y), colour_of(Tone::Waiting),
                  look.scale);
  }
  list->PushClipRect(from, to, true);
  std::vector<ImVec2> points;
  for (const PlotLine& line : lines) {
    points.clear();
    const std::size_t count = line.values->size();
    for (std::size_t i = 0; i < count; ++i) {
      const float age = static_cast<float>(count - 1 - i);
      const float x = end - age / (kSamplesWide - 1) * (end - from.x - inset);
      points.emplace_back(x, bottom - std::clamp((*line.values)[i], 0.0F, 1.0F) * reach);
    }
    list->AddPolyline(points.data(), static_cast<int>(points.size()), line.colour, 0,
                      1.5F * look.scale);
    if (line.marker < 0) continue;
    const std::size_t first = static_cast<std::size_t>(line.marker) * kMarkerEvery / kMarkers;
    for (std::size_t back = first; back < points.size(); back += kMarkerEvery) {
      draw_marker(line.marker, points[points.size() - 1 - back], kMarkerRadius * look.scale,
                  line.colour);
    }
  }
  if (labels > 0) line_labels(look, lines, end + inset, from.y + inset, bottom);
  scale_texts(scale, ImVec2(from.x + inset, from.y + inset), ImVec2(end, bottom), mark_y);
  list->PopClipRect();
  return clicked;
}

void line_name(const Look& look, int marker, const std::string& name) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float r = kMarkerRadius * look.scale;
  const unsigned colour = colour_of_line(static_cast<std::size_t>(marker));
  draw_marker(marker, ImVec2(at.x + r, at.y + ImGui::GetTextLineHeight() / 2), r, colour);
  ImGui::SetCursorScreenPos(ImVec2(at.x + 4 * r, at.y));
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(name.c_str());
  ImGui::PopStyleColor();
}

unsigned colour_of_line(std::size_t index) {
  // Apart for most eyes, also for those that do not tell red from green.
  constexpr std::array<unsigned, 6> kColours = {
      IM_COL32(86, 180, 233, 255), IM_COL32(230, 159, 0, 255),   IM_COL32(0, 200, 150, 255),
      IM_COL32(240, 228, 66, 255), IM_COL32(225, 120, 180, 255), IM_COL32(213, 94, 0, 255)};
  return kColours[index % kColours.size()];
}

}  // namespace aucast::gui
