#include <imgui.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

using Phase = MirrorView::Phase;

constexpr const char* kOnlyHere = "127.0.0.1";
constexpr const char* kEverywhere = "0.0.0.0";
/// Height by width of the area before there is a picture, and the most for any picture.
constexpr float kUsualShape = 0.75F;
constexpr float kBarHeight = 4;

void fill_mirror_form(const MirrorView& mirror, MirrorForm& form) {
  set_text(form.source, mirror.source.empty() ? "camera" : mirror.source);
  form.taken = mirror.source;
  form.filled = true;
}

void camera_buttons(const Look& look, const MirrorView& mirror, MirrorForm& form,
                    GuiCommands& commands) {
  heading(look, tr("camera.title"), tr("tip.mirror"));
  label(look, tr("camera.source"), tr("tip.camera"));
  const bool off = mirror.phase == Phase::Off;
  ImGui::BeginDisabled(!off);
  leave_room_to_choose(look);
  ImGui::InputTextWithHint("##source", "camera, camera:/dev/video2", form.source.data(),
                           form.source.size());
  tip(tr("tip.camera"));
  if (choose_button(look)) {
    commands.push_back(Browse{Purpose::CameraFilm});
  }
  tip(tr("tip.film"));
  ImGui::EndDisabled();
  if (wide_button(tr("camera.start"), 0, 2, off, off)) {
    commands.push_back(MirrorCommand(StartMirror{form.source.data()}));
  }
  tip(tr("tip.camera_start"));
  if (wide_button(tr("camera.stop"), 1, 2, !off && mirror.phase != Phase::Ending)) {
    commands.push_back(MirrorCommand(StopMirror{}));
  }
  tip(tr("tip.camera_stop"));
}

/// Draws over the picture, which begins at `at`.
void draw_landmarks(const Look& look, const preview::Seen& seen, ImVec2 at, ImVec2 size,
                    bool as_mirror) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = 0.8F * look.scale;
  ImVec4 colour = ImGui::GetStyleColorVec4(ImGuiCol_PlotLinesHovered);
  colour.w = 0.85F;
  const unsigned packed = ImGui::GetColorU32(colour);
  for (const preview::Point& point : seen.points) {
    const float x = at.x + size.x * (as_mirror ? 1 - point.x : point.x);
    const float y = at.y + size.y * point.y;
    list.AddRectFilled(ImVec2(x - half, y - half), ImVec2(x + half, y + half), packed);
  }
}

void say_in_the_middle(const char* text, ImVec2 at, ImVec2 size) {
  const ImVec2 room = ImGui::CalcTextSize(text, nullptr, false, size.x);
  ImGui::GetWindowDrawList()->AddText(
      ImGui::GetFont(), ImGui::GetFontSize(),
      ImVec2(at.x + (size.x - room.x) / 2, at.y + (size.y - room.y) / 2), colour_of(Tone::Quiet),
      text, nullptr, size.x);
}

/// The field shows the beginning of a path, and seldom the name of the film at its end.
std::string waiting_text(const MirrorView& mirror, const MirrorForm& form) {
  if (mirror.phase == Phase::Starting) return tr("camera.opening");
  const std::string_view source = form.source.data();
  if (mirror.phase != Phase::Off || !is_film_source(std::string(source))) {
    return tr("camera.no_picture");
  }
  return std::string(source.substr(source.find_last_of("/:") + 1));
}

/// What is left free around the text that is written in place of a picture.
float margin_of(const Look& look) {
  return 12 * look.scale;
}

/// Says in place of a picture why there is none.
void no_picture(const Look& look, const MirrorView& mirror, const MirrorForm& form, ImVec2 at,
                ImVec2 size) {
  if (mirror.trouble.empty()) {
    say_in_the_middle(waiting_text(mirror, form).c_str(), at, size);
    return;
  }
  const float margin = margin_of(look);
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                                      ImVec2(at.x + margin, at.y + margin),
                                      colour_of(mirror.expected ? Tone::Quiet : Tone::Bad),
                                      mirror.trouble.c_str(), nullptr, size.x - 2 * margin);
}

void picture(const Look& look, const MirrorView& mirror, MirrorForm& form) {
  const preview::Seen* seen = mirror.seen.get();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImVec2 frame(width, width * kUsualShape);
  // Large letters may need more for what is written in it.
  if (seen == nullptr && !mirror.trouble.empty()) {
    const float margin = margin_of(look);
    const char* const text = mirror.trouble.c_str();
    const float needed = ImGui::CalcTextSize(text, nullptr, false, width - 2 * margin).y;
    frame.y = std::max(frame.y, needed + 2 * margin);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = 6 * look.scale;
  list.AddRectFilled(at, ImVec2(at.x + frame.x, at.y + frame.y),
                     ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  ImGui::Dummy(frame);
  if (seen == nullptr || form.texture == 0) {
    no_picture(look, mirror, form, at, frame);
  } else {
    const float fit = std::min(frame.x / static_cast<float>(seen->width),
                               frame.y / static_cast<float>(seen->height));
    const ImVec2 size(static_cast<float>(seen->width) * fit,
                      static_cast<float>(seen->height) * fit);
    const ImVec2 from(at.x + (frame.x - size.x) / 2, at.y + (frame.y - size.y) / 2);
    const float left = form.as_mirror ? 1 : 0;
    list.AddImageRounded(reinterpret_cast<ImTextureID>(form.texture), from,
                         ImVec2(from.x + size.x, from.y + size.y), ImVec2(left, 0),
                         ImVec2(1 - left, 1), IM_COL32_WHITE, rounding);
    if (form.landmarks) draw_landmarks(look, *seen, from, size, form.as_mirror);
  }
  ImGui::Checkbox(tr("camera.as_mirror"), &form.as_mirror);
  tip(tr("camera.as_mirror_tip"));
  ImGui::SameLine();
  ImGui::Checkbox(tr("camera.landmarks"), &form.landmarks);
  tip(tr("tip.landmarks"));
  if (seen != nullptr && seen->points.empty()) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    toned_line(Tone::Waiting, tr("camera.no_face"));
  }
}

std::string name_of_bind(const std::string& bind) {
  if (bind == kOnlyHere) return tr("camera.only_here");
  if (bind == kEverywhere) return tr("camera.everywhere");
  return bind;
}

void address_and_port(const Look& look, const MirrorView& mirror, MirrorForm& form) {
  label(look, tr("camera.address"), tr("tip.camera_address"));
  const float port_width = 64 * look.scale;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - port_width -
                          ImGui::GetStyle().ItemInnerSpacing.x);
  if (ImGui::BeginCombo("##bind", name_of_bind(form.bind).c_str())) {
    std::vector<std::string> choices{kOnlyHere};
    choices.insert(choices.end(), mirror.addresses.begin(), mirror.addresses.end());
    choices.emplace_back(kEverywhere);
    for (const std::string& choice : choices) {
      if (list_item(name_of_bind(choice), choice == form.bind)) form.bind = choice;
    }
    ImGui::EndCombo();
  } else {
    tip(tr("tip.camera_address"));
  }
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::SetNextItemWidth(port_width);
  static_cast<void>(
      number_field("##liveport", form.port, {.most = RemoteSettings::kPortMax, .buttons = false}));
  tip(tr("camera.port_tip"));
}

void guests(const Look& look, const MirrorView& mirror, MirrorForm& form, GuiCommands& commands) {
  heading(look, tr("camera.others"));
  const bool live = mirror.phase == Phase::Live;
  const bool film = mirror.phase == Phase::Off && is_film_source(form.source.data());
  const bool can = film || mirror.phase == Phase::Private;
  ImGui::BeginDisabled(live);
  address_and_port(look, mirror, form);
  ImGui::EndDisabled();
  if (wide_button(tr("camera.go_live"), 0, 2, can, can && !film)) {
    commands.push_back(MirrorCommand(GoLive{form.bind, form.port, form.source.data()}));
  }
  tip(film ? tr("tip.film_live") : tr("tip.live"));
  if (wide_button(tr("camera.end"), 1, 2, live, live))
    commands.push_back(MirrorCommand(GoPrivate{}));
  tip(tr("tip.camera_end"));
  if (mirror.seen != nullptr && !mirror.trouble.empty()) {
    toned_text(mirror.expected ? Tone::Quiet : Tone::Bad, mirror.trouble);
  } else if (live) {
    toned_text(Tone::Good, viewers_text(mirror));
  } else {
    quiet_text(viewers_text(mirror));
  }
  quiet_text(admission_text(mirror));
  tip(tr("tip.admission"));
  quiet_text(tr("camera.private_note"));
}

/// A bar from the middle to both sides; the subject's left is on the same side as in the picture.
void bar(const Look& look, const AuBar& one, float width, bool as_mirror) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float text_height = ImGui::GetTextLineHeight();
  const float height = kBarHeight * look.scale;
  const bool absent = one.left_percent + one.right_percent == 0;
  const ImVec2 cursor = ImGui::GetCursorPos();
  fitted_text(one.label, at.x + width,
              absent ? colour_of(Tone::Quiet) : ImGui::GetColorU32(ImGuiCol_Text));
  ImGui::SetCursorPos(cursor);
  ImGui::Dummy(ImVec2(width, text_height + height + 2 * look.scale));
  tip(tr("camera.sides", one.label, one.left_percent, one.right_percent));
  const float top = at.y + text_height + look.scale;
  const float middle = at.x + width / 2;
  list.AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + width, top + height),
                     ImGui::GetColorU32(ImGuiCol_FrameBg), height / 2);
  const auto reach = [&](int percent) {
    return width / 2 * static_cast<float>(std::clamp(percent, 0, 100)) / 100;
  };
  const float to_left = reach(as_mirror ? one.left_percent : one.right_percent);
  const float to_right = reach(as_mirror ? one.right_percent : one.left_percent);
  if (absent) return;
  list.AddRectFilled(ImVec2(middle - to_left, top), ImVec2(middle + to_right, top + height),
                     ImGui::GetColorU32(ImGuiCol_PlotLines), height / 2);
}

void face_bars(const Look& look, const MirrorView& mirror, bool as_mirror) {
  heading(look, tr("camera.aus"), tr("tip.au"));
  if (mirror.seen == nullptr || mirror.seen->aus.empty()) {
    quiet_text(mirror.seen == nullptr ? tr("camera.none_yet") : tr("camera.none_without"));
    return;
  }
  const std::vector<AuBar> bars = au_bars(mirror.seen->aus);
  const float gap = 16 * look.scale;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const float left = ImGui::GetCursorPosX();
  for (std::size_t i = 0; i < bars.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(left + width + gap);
    bar(look, bars[i], width, as_mirror);
  }
}

}  // namespace

void mirror_panel(const Look& look, const GuiModel& model, MirrorForm& form,
                  GuiCommands& commands) {
  const MirrorView& mirror = model.mirror;
  if (!form.filled || form.taken != mirror.source) fill_mirror_form(mirror, form);
  camera_buttons(look, mirror, form, commands);
  picture(look, mirror, form);
  guests(look, mirror, form, commands);
  face_bars(look, mirror, form.as_mirror);
}

}  // namespace aucast::gui
