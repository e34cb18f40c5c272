#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

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

/// Address and port, with the last ones in a list.
bool address(const Look& look, const GuiModel& model, RemoteForm& form) {
  label(look, "Address, port");
  const float arrow = ImGui::GetFrameHeight();
  const float port = 58 * look.scale;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - port - arrow - 2 * gap);
  const bool entered = ImGui::InputText("##address", form.address.data(), form.address.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
  form.settings.address = form.address.data();
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(port);
  ImGui::InputInt("##port", &form.settings.port, 0);
  ImGui::SameLine(0, gap);
  ImGui::BeginDisabled(model.recent.empty());
  if (ImGui::BeginCombo("##recent", "", ImGuiComboFlags_NoPreview)) {
    for (const std::string& recent : model.recent) {
      RemoteSettings chosen = form.settings;
      if (ImGui::Selectable(recent.c_str()) && take_endpoint(recent, chosen)) {
        fill_form(chosen, form);
      }
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  return entered;
}

/// Each has its own place whatever the state: a second click on a button must never be another's.
void connect_buttons(const GuiModel& model, const RemoteForm& form, bool entered,
                     const std::optional<std::string>& wrong, GuiCommands& commands) {
  const Activity activity = model.remote.activity;
  const bool connecting = activity == Activity::Connecting;
  const bool paused = activity == Activity::Paused;
  const bool running =
      !model.remote.local && (connecting || paused || activity == Activity::Playing);
  // A mistyped server may be corrected while it is still being tried.
  const bool corrected = form.settings.address != model.remote_settings.address ||
                         form.settings.port != model.remote_settings.port;
  const bool may_connect = (!running || corrected) && !wrong;
  const bool pressed = wide_button("Connect", 0, 3, may_connect, may_connect);
  if ((pressed || entered) && may_connect) commands.push_back(Connect{form.settings});
  const bool resumes = running && paused;
  if (wide_button(resumes ? "Resume" : "Pause", 1, 3, running && !connecting)) {
    if (resumes) {
      commands.push_back(Resume{});
    } else {
      commands.push_back(Pause{});
    }
  }
  if (wide_button("Stop", 2, 3, running)) commands.push_back(Stop{});
}

void server(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands) {
  heading(look, "Server");
  const bool entered = address(look, model, form);
  const auto wrong = problem(form.settings);
  connect_buttons(model, form, entered, wrong, commands);
  if (wrong) quiet_text(*wrong);
}

/// A fact, in less room than something to set.
void said(const Look& look, const char* name, const std::string& value) {
  quiet_text(name);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + 112 * look.scale);
  quiet_text(value);
}

void buffers(const Look& look, const GuiModel& model, RemoteForm& form) {
  heading(look, "Buffers");
  const RemoteView& remote = model.remote;
  buffer_bar(look, "Receiver", remote.receiver);
  buffer_bar(look, "Playout", remote.playout);
  if (!remote.receiver_history.empty()) {
    label(look, "Last 30 s");
    const PlotLine line{&remote.receiver_history, ImGui::GetColorU32(ImGuiCol_PlotLines)};
    plot(look, {&line, 1}, 34 * look.scale,
         static_cast<float>(remote.receiver.threshold_percent) / 100);
  }
  if (!remote.in.empty()) {
    said(look, "Received", remote.in);
    said(look, "Sent", remote.out);
    said(look, "Protocol", remote.protocol);
    if (!remote.delay.empty()) said(look, "Delay", remote.delay);
  }
  if (ImGui::TreeNodeEx("For the next connection",
                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
    number(look, "Buffer", "##buffer", form.settings.buffer);
    number(look, "Playout", "##playout", form.settings.playout);
    number(look, "Threshold %", "##threshold", form.settings.threshold_percent);
    number(look, "Speed ms", "##speed", form.settings.speed_ms);
    quiet_text("Speed is for keyframes without a time of their own; 0: the server's.");
    label(look, "When lost");
    ImGui::Checkbox("connect again", &form.settings.reconnect);
  }
}

/// The strongest AUs over the last half minute, each with its colour.
void intensities(const Look& look, const RemoteView& remote) {
  if (remote.au_history.empty()) return;
  std::vector<PlotLine> lines;
  label(look, "Last 30 s");
  const float left = ImGui::GetCursorPosX();
  for (std::size_t i = 0; i < remote.au_history.size(); ++i) {
    lines.push_back({&remote.au_history[i].values, colour_of_line(i)});
  }
  plot(look, lines, 48 * look.scale, 0);
  ImGui::SetCursorPosX(left);
  for (std::size_t i = 0; i < remote.au_history.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 10 * look.scale);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour_of_line(i)), "%d",
                       remote.au_history[i].number);
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

void action_units(const Look& look, const GuiModel& model) {
  heading(look, "Action Units");
  intensities(look, model.remote);
  if (model.remote.aus.empty()) {
    quiet_text(model.remote.keyframe.empty() ? "None yet." : "The neutral face.");
    return;
  }
  au_table(look, "received", model.remote.aus);
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
