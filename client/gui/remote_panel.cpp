#include <imgui.h>

#include <algorithm>
#include <cstring>

#include "client/gui/panels.h"

namespace aucast::gui {
namespace {

constexpr std::array kMixers = {"Maximum", "Average"};
constexpr std::array kRules = {"facs", "kumar2010", "none"};
constexpr std::array kInterpolations = {"Linear", "Cosine"};

void fill_form(const RemoteSettings& settings, RemoteForm& form) {
  form.settings = settings;
  const std::size_t length = std::min(settings.address.size(), form.address.size() - 1);
  std::memcpy(form.address.data(), settings.address.data(), length);
  form.address[length] = 0;
  form.filled = true;
}

/// A whole number that is typed or stepped; the limits are checked by problem().
void number(const Look& look, const char* name, const char* id, int& value) {
  label(look, name);
  ImGui::InputInt(id, &value, 1, 10);
}

void server(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands) {
  heading(look, "Server");
  label(look, "Address");
  const bool entered = ImGui::InputText("##address", form.address.data(), form.address.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
  form.settings.address = form.address.data();
  label(look, "Port");
  ImGui::InputInt("##port", &form.settings.port, 0);
  const auto wrong = problem(form.settings);
  const Activity activity = model.remote.activity;
  const bool running =
      !model.remote.local && (activity == Activity::Connecting || activity == Activity::Playing ||
                              activity == Activity::Paused);
  if (!running) {
    const bool pressed = wide_button("Connect", 0, 1, !wrong, true);
    if ((pressed || entered) && !wrong) commands.push_back(Connect{form.settings});
  } else {
    const bool paused = activity == Activity::Paused;
    if (wide_button(paused ? "Resume" : "Pause", 0, 2, activity != Activity::Connecting)) {
      if (paused) {
        commands.push_back(Resume{});
      } else {
        commands.push_back(Pause{});
      }
    }
    if (wide_button("Stop", 1, 2, true)) commands.push_back(Stop{});
  }
  if (wrong) quiet_text(*wrong);
}

void buffers(const Look& look, const GuiModel& model, RemoteForm& form) {
  heading(look, "Buffers");
  buffer_bar(look, "Receiver", model.remote.receiver);
  buffer_bar(look, "Playout", model.remote.playout);
  const std::vector<float>& history = model.remote.receiver_history;
  if (!history.empty()) {
    label(look, "Last 30 s");
    ImGui::PlotLines("##history", history.data(), static_cast<int>(history.size()), 0, nullptr, 0,
                     1, ImVec2(0, 34 * look.scale));
  }
  if (!model.remote.traffic.empty()) quiet_text(model.remote.traffic);
  if (ImGui::TreeNodeEx("Sizes and speed",
                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
    number(look, "Buffer", "##buffer", form.settings.buffer);
    number(look, "Playout", "##playout", form.settings.playout);
    number(look, "Threshold %", "##threshold", form.settings.threshold_percent);
    number(look, "Speed ms", "##speed", form.settings.speed_ms);
    quiet_text("For the next connection. Speed 0 is the server's own.");
  }
}

void animation(const Look& look, const GuiModel& model, GuiCommands& commands) {
  heading(look, "Animation");
  AnimationSettings settings = model.animation;
  bool changed = false;
  label(look, "Mixer");
  int mixer = settings.mixer == face::Mixer::Average ? 1 : 0;
  if (choice("mixer", kMixers, mixer)) {
    settings.mixer = mixer == 1 ? face::Mixer::Average : face::Mixer::Maximum;
    changed = true;
  }
  label(look, "In between");
  int kind = settings.interpolation == playback::Interpolation::Cosine ? 1 : 0;
  if (choice("interpolation", kInterpolations, kind)) {
    settings.interpolation =
        kind == 1 ? playback::Interpolation::Cosine : playback::Interpolation::Linear;
    changed = true;
  }
  label(look, "Rules");
  const auto found = std::find(kRules.begin(), kRules.end(), settings.rules);
  int rules = found == kRules.end() ? -1 : static_cast<int>(found - kRules.begin());
  if (choice("rules", kRules, rules)) {
    settings.rules = kRules[static_cast<std::size_t>(rules)];
    changed = true;
  }
  if (found == kRules.end()) quiet_text("from " + settings.rules);
  if (changed) commands.push_back(ChangeAnimation{settings});
}

void percent(int value, bool differs) {
  if (value == 0) {
    ImGui::TextDisabled("-");
  } else if (differs) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour_of(Tone::Waiting)), "%d", value);
  } else {
    ImGui::Text("%d", value);
  }
}

void action_units(const Look& look, const GuiModel& model) {
  heading(look, "Action Units");
  if (model.remote.aus.empty()) {
    quiet_text(model.remote.keyframe.empty() ? "None yet." : "The neutral face.");
    return;
  }
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("aus", 4, kFlags)) return;
  ImGui::TableSetupColumn("AU", 0, 34 * look.scale);
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("came", 0, 40 * look.scale);
  ImGui::TableSetupColumn("shown", 0, 44 * look.scale);
  ImGui::TableHeadersRow();
  for (const AuRow& row : model.remote.aus) {
    const bool differs = row.received_percent != row.shown_percent;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.label.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.name.c_str());
    if (!row.why.empty()) quiet_text("rule: " + row.why);
    ImGui::TableNextColumn();
    percent(row.received_percent, false);
    ImGui::TableNextColumn();
    percent(row.shown_percent, differs);
  }
  ImGui::EndTable();
}

}  // namespace

void remote_panel(const Look& look, const GuiModel& model, RemoteForm& form,
                  GuiCommands& commands) {
  if (!form.filled) fill_form(model.remote_settings, form);
  server(look, model, form, commands);
  file_part(model, commands);
  record_part(model, commands);
  if (!model.remote.local) buffers(look, model, form);
  animation(look, model, commands);
  action_units(look, model);
}

}  // namespace aucast::gui
