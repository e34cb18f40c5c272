#include <imgui.h>

#include <algorithm>
#include <cstring>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr float kDialogWidth = 460;

template <std::size_t N>
bool text_field(const char* id, const char* hint, const std::string& now, std::array<char, N>& text,
                std::string& taken) {
  if (taken != now) {
    taken = now;
    set_text(text, now);
  }
  const bool changed = ImGui::InputTextWithHint(id, hint, text.data(), N);
  if (!changed) return false;
  taken = text.data();
  return true;
}

bool folder_field(const Look& look, GallerySettings& settings, GalleryForm& form,
                  GuiCommands& commands) {
  label(look, tr("gallery.folder"), tr("tip.gallery_folder"));
  leave_room_to_choose(look);
  const bool changed = text_field("##folder", tr("gallery.folder_hint"), settings.folder,
                                  form.folder, form.folder_taken);
  tip(tr("tip.gallery_folder"));
  if (changed) settings.folder = form.folder.data();
  if (choose_button(look)) {
    commands.push_back(Browse{Purpose::GalleryFolder});
  }
  return changed;
}

bool sections(const Look& look, GallerySettings& settings) {
  bool changed = false;
  label(look, tr("gallery.pictures_of"), tr("tip.gallery_sections"));
  const float left = ImGui::GetCursorPosX();
  const float half = (ImGui::GetWindowContentRegionMax().x - left) / 2;
  for (std::size_t i = 0; i < kGallerySections.size(); ++i) {
    if (i % 2 == 1) {
      ImGui::SameLine(left + half);
    } else {
      ImGui::SetCursorPosX(left);
    }
    changed |= ImGui::Checkbox(tr(kGallerySections[i].text), &settings.sections[i]);
    tip(tr(kGallerySections[i].tip));
  }
  return changed;
}

bool sweeps(const Look& look, GallerySettings& settings, GalleryForm& form) {
  if (!settings.sections.back()) return false;
  label(look, tr("gallery.sweeps_of"), tr("gallery.sweeps_of_tip"));
  const bool changed = text_field("##sweeps", "12  6,12  happiness  all", settings.sweeps,
                                  form.sweeps, form.sweeps_taken);
  if (changed) settings.sweeps = form.sweeps.data();
  tip(tr("gallery.sweeps_of_tip"));
  return changed;
}

bool size(const Look& look, GallerySettings& settings) {
  label(look, tr("gallery.size"), tr("tip.gallery_size"));
  const float by = ImGui::CalcTextSize(" x ").x;
  const float each = (ImGui::GetContentRegionAvail().x - by) / 2;
  ImGui::SetNextItemWidth(each);
  bool changed = ImGui::InputInt("##width", &settings.width, 0);
  tip(tr("tip.gallery_size"));
  ImGui::SameLine(0, 0);
  ImGui::TextUnformatted(" x ");
  ImGui::SameLine(0, 0);
  ImGui::SetNextItemWidth(each);
  changed |= ImGui::InputInt("##height", &settings.height, 0);
  tip(tr("tip.gallery_size"));
  return changed;
}

void progress(const GalleryView& view) {
  const float share =
      view.total == 0 ? 0.0F : static_cast<float>(view.drawn) / static_cast<float>(view.total);
  ImGui::ProgressBar(share, ImVec2(-1, 0), progress_text(view).c_str());
}

}  // namespace

void gallery_dialog(const Look& look, const GuiModel& model, float width, GalleryForm& form,
                    GuiCommands& commands) {
  const GalleryView& view = model.gallery;
  if (!view.open) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float own = std::min(kDialogWidth * look.scale, screen.x - 20);
  // Beside the panel if there is room; what is higher than the window is scrolled to.
  const float middle = (own <= width ? width : screen.x) / 2;
  ImGui::SetNextWindowSizeConstraints(ImVec2(own, 0), ImVec2(own, screen.y - 20));
  ImGui::SetNextWindowPos(ImVec2(middle, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(own, 0));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
  const FloatingStyle floating(look);
  bool shown = true;
  if (ImGui::Begin(with_id(tr("gallery.title"), "gallery").c_str(), &shown, kFlags)) {
    GallerySettings settings = view.settings;
    ImGui::BeginDisabled(view.running);
    bool changed = folder_field(look, settings, form, commands);
    changed |= sections(look, settings);
    changed |= sweeps(look, settings, form);
    changed |= size(look, settings);
    ImGui::EndDisabled();
    if (changed) commands.push_back(GalleryCommand(ChangeGallery{settings}));
    quiet_text(tr("gallery.help"));
    const std::string missing = problem(settings);
    const std::string& wrong = missing.empty() ? view.complaint : missing;
    // Always a line, so that no button moves when it begins.
    if (view.running) {
      progress(view);
    } else if (!view.outcome.empty()) {
      toned_text(view.failed ? Tone::Bad : view.stopped ? Tone::Waiting : Tone::Good, view.outcome);
    } else {
      const float top = ImGui::GetCursorPosY();
      ImGui::AlignTextToFramePadding();
      if (missing.empty() && !wrong.empty()) {
        toned_text(Tone::Bad, wrong);
      } else {
        quiet_text(wrong.empty() ? tr("gallery.planned", view.planned) : wrong);
      }
      ImGui::SetCursorPosY(top + ImGui::GetFrameHeightWithSpacing());
    }
    if (wide_button(tr("button.cancel"), 0, 2, !view.ending)) {
      commands.push_back(view.running ? GalleryCommand(CancelGallery{})
                                      : GalleryCommand(CloseGallery{}));
    }
    tip(tr("tip.gallery_cancel"));
    const bool may_begin = !view.running && wrong.empty();
    if (wide_button(tr("gallery.make"), 1, 2, may_begin, may_begin)) {
      commands.push_back(GalleryCommand(BeginGallery{}));
    }
    tip(tr("tip.gallery_make"));
  }
  ImGui::End();
  if (!shown) commands.push_back(GalleryCommand(CloseGallery{}));
}

}  // namespace aucast::gui
