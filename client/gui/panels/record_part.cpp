#include <imgui.h>

#include <array>
#include <filesystem>
#include <string>

#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

constexpr Steps kSideSteps{10, 100, kPictureSideMin, kPictureSideMax};

/// What is being written at present, each in a line. `whole`: with the whole paths of the files, in
/// place of their names.
std::string under_way(const GuiModel& model, bool whole) {
  std::string lines;
  const auto add = [&lines](const std::string& line) {
    lines += (lines.empty() ? "" : "\n") + line;
  };
  const auto named = [whole](const std::string& file) {
    return whole ? file : std::filesystem::path(file).filename().string();
  };
  const VideoView& video = model.video;
  if (!video.recording.empty()) add(tr("play.recording", named(video.recording)));
  if (!video.completing.empty()) add(tr("play.completing", named(video.completing)));
  const ExportView& exported = model.exported;
  if (!exported.file.empty()) add(tr("play.writing", named(exported.file), exported.percent));
  const GalleryView& gallery = model.gallery;
  if (gallery.running && !gallery.open) add(tr("play.gallery_runs", progress_text(gallery)));
  if (!model.onsets.empty()) add(tr("play.times_go", named(model.onsets)));
  return lines;
}

/// Says what is being written at the right of the line that begins with `label`, so that nothing
/// below moves when it begins or ends.
void say_under_way(const GuiModel& model, const char* label) {
  std::string text = under_way(model, false);
  if (text.empty()) return;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
    text.replace(at, 1, ", ");
  }
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing() +
                  ImGui::CalcTextSize(label).x + ImGui::GetStyle().ItemSpacing.x);
  fitted_text(text, right, colour_of(Tone::Quiet));
}

/// Where pictures and videos are saved, initially folded, and what is being written there.
void where_they_go(const Look& look, const GuiModel& model, RecordForm& form,
                   GuiCommands& commands) {
  const PictureSettings& now = model.pictures;
  const bool open = foldable(tr("play.where"));
  const std::string written = under_way(model, true);
  tip(tr("tip.where") + (written.empty() ? written : "\n" + written));
  say_under_way(model, tr("play.where"));
  if (!open) return;
  if (!form.filled || form.taken != now) {
    if (!form.filled || form.taken.folder != now.folder) set_text(form.folder, now.folder);
    if (!form.filled || form.taken.pattern != now.pattern) set_text(form.name, now.pattern);
    form.taken = now;
    form.filled = true;
  }
  PictureSettings wanted = now;
  label(look, tr("play.folder"), tr("tip.picture_folder"));
  leave_room_to_choose(look);
  ImGui::InputTextWithHint("##picturefolder", tr("play.folder_hint"), form.folder.data(),
                           form.folder.size());
  tip(tr("tip.picture_folder"));
  if (ImGui::IsItemDeactivatedAfterEdit()) wanted.folder = form.folder.data();
  if (choose_button(look)) {
    commands.push_back(Browse{Purpose::PictureFolder});
  }
  if (model.picture_folder != now.folder) quiet_text(model.picture_folder);
  const std::string name_help =
      tr("play.name_tip", "{number}", "{face}", "{stream}", "{keyframe}", "{aus}", "{date}");
  label(look, tr("play.name"), name_help.c_str());
  if (ImGui::InputText("##picturename", form.name.data(), form.name.size())) {
    wanted.pattern = form.name.data();
  }
  tip(name_help);
  if (const auto name = picture_name(wanted.pattern, {}, 1); !name) {
    toned_text(Tone::Bad, name.error().message);
  }
  label(look, tr("play.size"), tr("tip.picture_size"));
  int kind = now.width == 0 ? 0 : now.width == 1920 && now.height == 1080 ? 1 : 2;
  const std::array<Word, 3> sizes = {{{tr("play.size_window"), tr("tip.picture_size")},
                                      {"1920 x 1080", tr("tip.picture_size")},
                                      {tr("play.size_other"), tr("tip.picture_size")}}};
  if (choice("size", sizes, kind)) {
    wanted.width = kind == 0 ? 0 : kind == 1 ? 1920 : 800;
    wanted.height = kind == 0 ? 0 : kind == 1 ? 1080 : 1000;
  }
  if (kind == 2) {
    const std::string limits = tr("play.side_tip", kPictureSideMin, kPictureSideMax);
    number_row(look, tr("play.width"), "##picturewidth", wanted.width, kSideSteps, limits.c_str());
    number_row(look, tr("play.height"), "##pictureheight", wanted.height, kSideSteps,
               limits.c_str());
  }
  if (wanted == now) return;
  form.taken = wanted;
  commands.push_back(ChangePictures{wanted});
}

/// The menu of exports for other programs.
void export_menu(const GuiModel& model, GuiCommands& commands) {
  if (!ImGui::BeginPopup("export")) return;
  const auto item = [&](const char* text, Purpose purpose, bool enabled) {
    if (ImGui::MenuItem(text, nullptr, false, enabled)) commands.push_back(Browse{purpose});
  };
  const bool played = !model.playing.keyframe.empty();
  item(tr("play.export_keyframes"), Purpose::ExportKeyframes, played);
  item(tr("play.export_table"), Purpose::ExportTable, played);
  const ExportView& now = model.exported;
  if (now.file.empty()) {
    item(tr("play.export_glb"), Purpose::ExportGlb, true);
  } else if (ImGui::MenuItem(tr("play.cancel_glb"), nullptr, false, !now.ending)) {
    commands.push_back(CancelExport{});
  }
  item(tr("play.export_mesh"), Purpose::ExportMesh, true);
  if (model.onsets.empty()) {
    item(tr("play.onsets"), Purpose::LogOnsets, true);
  } else if (ImGui::MenuItem(tr("play.end_onsets"))) {
    commands.push_back(EndOnsets{});
  }
  ImGui::EndPopup();
}

}  // namespace

void record_part(const Look& look, const GuiModel& model, RecordForm& form, GuiCommands& commands) {
  const bool recording = !model.video.recording.empty();
  if (wide_button(tr("play.picture"), 0, 4, true)) commands.push_back(TakePicture{});
  tip(tr("play.picture_tip"));
  if (wide_button(recording ? tr("play.end_video") : tr("play.video"), 1, 4,
                  model.video.completing.empty(), recording)) {
    commands.push_back(ToggleVideo{});
  }
  tip(recording ? tr("play.end_video_tip") : tr("play.video_tip"));
  if (wide_button(tr("play.gallery"), 2, 4, true, model.gallery.running)) {
    commands.push_back(GalleryCommand(OpenGallery{}));
  }
  tip(tr("play.gallery_tip"));
  if (wide_button(tr("button.export"), 3, 4, true)) ImGui::OpenPopup("export");
  tip(tr("play.export_tip"));
  export_menu(model, commands);
  where_they_go(look, model, form, commands);
}

}  // namespace aucast::gui
