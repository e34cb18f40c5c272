#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "client/gui/panels.h"
#include "common/action_unit.h"

namespace aucast::gui {
namespace {

constexpr std::array kMixers = {"Maximum", "Average"};
constexpr std::array kRules = {"facs", "kumar2010", "none"};

void write(const std::string& text, std::span<char> out) {
  const std::size_t length = std::min(text.size(), out.size() - 1);
  std::memcpy(out.data(), text.data(), length);
  out[length] = 0;
}

void fill_form(const RemoteSettings& settings, RemoteForm& form) {
  form.settings = settings;
  write(address_text(settings), form.address);
  write(settings.token_file, form.token_file);
  form.wrong.reset();
  form.filled = true;
}

/// A whole number that is typed or stepped; the limits are checked by problem().
void number(const Look& look, const char* name, const char* id, int& value) {
  label(look, name);
  ImGui::InputInt(id, &value, 1, 10);
}

/// One field for host, port and stream, with the last ones in a list.
bool address(const Look& look, const GuiModel& model, RemoteForm& form) {
  label(look, "Address");
  const float arrow = ImGui::GetFrameHeight();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - arrow - gap);
  const std::string before = form.address.data();
  const bool entered = ImGui::InputTextWithHint(
      "##address", "HOST, HOST:PORT, aucast://HOST/STREAM", form.address.data(),
      form.address.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (before != form.address.data()) form.wrong = take_address(form.address.data(), form.settings);
  ImGui::SameLine(0, gap);
  ImGui::BeginDisabled(model.recent.empty());
  if (ImGui::BeginCombo("##recent", "", ImGuiComboFlags_NoPreview)) {
    for (const std::string& recent : model.recent) {
      RemoteSettings chosen = form.settings;
      if (ImGui::Selectable(recent.c_str()) && !take_address(recent, chosen)) {
        fill_form(chosen, form);
      }
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  return entered;
}

/// What the server has, asked when the list is opened; the chosen one is connected to.
void stream(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands) {
  label(look, "Stream");
  const std::string& chosen = form.settings.stream;
  if (!ImGui::BeginCombo("##stream", chosen.empty() ? "the server's first" : chosen.c_str()))
    return;
  const bool good = !form.wrong && !problem(form.settings);
  if (ImGui::IsWindowAppearing() && good) commands.push_back(AskStreams{form.settings});
  const StreamsView& streams = model.streams;
  if (!good) ImGui::TextDisabled("no address");
  if (streams.asking) ImGui::TextDisabled("asking ...");
  if (!streams.problem.empty()) quiet_text(streams.problem);
  for (const std::string& name : streams.names) {
    if (!ImGui::Selectable(name.c_str(), name == chosen)) continue;
    RemoteSettings settings = form.settings;
    settings.stream = name;
    fill_form(settings, form);
    commands.push_back(Connect{settings});
  }
  ImGui::EndCombo();
}

/// Each has its own place whatever the state: a second click on a button must never be another's.
void connect_buttons(const GuiModel& model, const RemoteForm& form, bool entered,
                     const std::optional<std::string>& wrong, GuiCommands& commands) {
  const RemoteView& remote = model.remote;
  const bool connecting = remote.activity == Activity::Connecting;
  const bool paused = remote.activity == Activity::Paused;
  const bool running =
      !remote.local && (connecting || paused || remote.activity == Activity::Playing);
  // What is mistyped may be corrected while it is tried, and who waits for a server that was lost
  // may try it now.
  const bool corrected = form.settings != model.remote_settings;
  const bool lost = running && !remote.detail.empty();
  const bool may_connect = (!running || corrected || lost) && !wrong;
  const bool pressed = wide_button("Connect", 0, 3, may_connect, may_connect);
  if ((pressed && may_connect) || (entered && !wrong)) commands.push_back(Connect{form.settings});
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
  stream(look, model, form, commands);
  const auto wrong = form.wrong ? form.wrong : problem(form.settings);
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
    static_cast<void>(plot(look, {&line, 1}, 34 * look.scale,
                           static_cast<float>(remote.receiver.threshold_percent) / 100));
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
    if (remote.timed && form.settings.speed_ms > 0) {
      toned_text(Tone::Waiting,
                 "The keyframes of this stream have times of their own: the speed does nothing.");
    } else {
      quiet_text("Speed is for keyframes without a time of their own; 0: the server's.");
    }
    label(look, "When lost");
    ImGui::Checkbox("connect again", &form.settings.reconnect);
    label(look, "Protection");
    if (ImGui::Checkbox("TLS", &form.settings.tls)) {
      write(address_text(form.settings), form.address);
    }
    label(look, "Token file");
    ImGui::InputText("##token", form.token_file.data(), form.token_file.size());
    form.settings.token_file = form.token_file.data();
  }
}

/// The strongest AUs over the last half minute, each with its colour and its number beside it; a
/// click makes it larger, with their names.
void intensities(const Look& look, const RemoteView& remote, bool& large) {
  if (remote.au_history.empty()) return;
  constexpr float kSmall = 96;
  constexpr float kLarge = 260;
  std::vector<PlotLine> lines;
  for (std::size_t i = 0; i < remote.au_history.size(); ++i) {
    const AuTrace& trace = remote.au_history[i];
    lines.push_back({&trace.values, colour_of_line(i), std::to_string(trace.number)});
  }
  quiet_text("The strongest, last 30 s");
  if (plot(look, lines, (large ? kLarge : kSmall) * look.scale, 0)) large = !large;
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(large ? "a click makes it smaller" : "a click makes it larger");
  if (!large) return;
  for (std::size_t i = 0; i < remote.au_history.size(); ++i) {
    const int number = remote.au_history[i].number;
    const auto name = facs_name(number);
    const std::string text = std::to_string(number) + "  " + (name ? std::string(*name) : "");
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of_line(i));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
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
  changed |= in_between(look, "interpolation", settings.interpolation);
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

void action_units(const Look& look, const GuiModel& model, RemoteForm& form) {
  heading(look, "Action Units");
  intensities(look, model.remote, form.large_chart);
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
  record_part(look, model, form.record, commands);
  sound_part(look, model, commands);
  if (!model.remote.local) buffers(look, model, form);
  animation(look, model, commands);
  action_units(look, model, form);
  curves_part(look, model, form.curves, commands);
}

}  // namespace aucast::gui
