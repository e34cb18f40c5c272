#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/gui/model/fill_scale.h"
#include "client/gui/model/view_text.h"
#include "client/gui/panels/panels.h"
#include "client/gui/texts/texts.h"
#include "client/gui/widgets/au_table.h"
#include "client/gui/widgets/fields.h"
#include "client/gui/widgets/plot.h"
#include "client/gui/widgets/tips.h"

namespace aucast::gui {
namespace {

/// Longer titles of streams are cut.
constexpr float kTitleWidth = 280;

constexpr std::array kRules = {"facs", "kumar2010", "none"};

void fill_form(const RemoteSettings& settings, RemoteForm& form) {
  form.settings = settings;
  set_text(form.address, server_text(settings));
  set_text(form.authorities_file, settings.authorities_file);
  set_text(form.token_file, settings.token_file);
  form.wrong.reset();
  form.filled = true;
}

/// One field for host, port and stream, with a list of the recent ones. It has the width of the
/// panel, or a whole address would not fit; the heading above it says what it is.
bool address(const GuiModel& model, RemoteForm& form) {
  const float arrow = ImGui::GetFrameHeight();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - arrow - gap);
  const std::string before = form.address.data();
  const bool entered = ImGui::InputTextWithHint(
      "##address", tr("play.address_hint"), form.address.data(), form.address.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (before != form.address.data()) {
    form.wrong = take_address(form.address.data(), form.settings);
    form.renamed = true;
  }
  const std::string written = form.address.data();
  tip(written + (written.empty() ? "" : "\n") + tr("tip.address"));
  ImGui::SameLine(0, gap);
  ImGui::BeginDisabled(model.recent.empty());
  if (ImGui::BeginCombo("##recent", "", ImGuiComboFlags_NoPreview)) {
    for (const std::string& recent : model.recent) {
      RemoteSettings chosen = form.settings;
      if (list_item(recent, false) && !take_address(recent, chosen)) {
        fill_form(chosen, form);
        form.renamed = true;
      }
    }
    ImGui::EndCombo();
  } else {
    tip(tr("tip.recent"));
  }
  ImGui::EndDisabled();
  return entered;
}

/// The server does not say it of each stream, but of the one that plays it is known.
std::string words_of(const GuiModel& model, const protocol::ListedStream& stream) {
  const std::string words = stream_in_words(stream);
  if (!words.empty() || !model.playing.live || stream.name != model.playing.stream) return words;
  return *model.playing.live ? tr("play.is_live") : tr("play.is_recorded");
}

/// Its streams, each a line: name, whether it is live or how long it is, title. The chosen one;
/// null: none.
const protocol::ListedStream* list_of_streams(const Look& look, const GuiModel& model,
                                              const std::string& chosen) {
  float words_at = 0;
  float title_at = 0;
  for (const protocol::ListedStream& stream : model.streams.streams) {
    words_at = std::max(words_at, ImGui::CalcTextSize(stream.name.c_str()).x);
    title_at = std::max(title_at, ImGui::CalcTextSize(words_of(model, stream).c_str()).x);
  }
  const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
  words_at += ImGui::GetCursorPosX() + gap;
  title_at += words_at + gap;
  const float right = ImGui::GetWindowPos().x + title_at + kTitleWidth * look.scale;
  const protocol::ListedStream* taken = nullptr;
  for (const protocol::ListedStream& stream : model.streams.streams) {
    const bool is_chosen = stream.name == chosen;
    if (list_item(stream.name, is_chosen)) taken = &stream;
    // Grey could hardly be read where the line is marked.
    const ImU32 colour = ImGui::GetColorU32(is_chosen ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    const std::string words = words_of(model, stream);
    if (!words.empty()) {
      ImGui::SameLine(words_at);
      fitted_text(words, right, colour);
    }
    if (stream.title.empty()) continue;
    ImGui::SameLine(title_at);
    fitted_text(stream.title, right, colour);
  }
  return taken;
}

/// What the server has, asked when the list is opened; the chosen one is connected to.
void stream(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands) {
  label(look, tr("play.stream"), tr("tip.stream"));
  const std::string& asked = form.settings.stream;
  const bool its_first = asked.empty() && form.settings == model.remote_settings;
  const std::string& chosen = its_first ? model.playing.stream : asked;
  if (!ImGui::BeginCombo("##stream", chosen.empty() ? tr("play.first_stream") : chosen.c_str())) {
    return tip(tr("tip.stream"));
  }
  const bool good = !form.wrong && !problem(form.settings);
  if (ImGui::IsWindowAppearing() && good) commands.push_back(AskStreams{form.settings});
  const StreamsView& streams = model.streams;
  if (!good) ImGui::TextDisabled("%s", tr("play.no_address"));
  if (streams.asking) ImGui::TextDisabled("%s", tr("play.asking"));
  if (!streams.problem.empty()) quiet_text(streams.problem);
  if (const auto* const taken = list_of_streams(look, model, chosen)) {
    RemoteSettings settings = form.settings;
    settings.stream = taken->name;
    fill_form(settings, form);
    commands.push_back(Connect{settings});
  }
  ImGui::EndCombo();
}

/// Each button keeps its place in all states, so that a second click never hits another one.
void connect_buttons(const GuiModel& model, const RemoteForm& form, bool entered,
                     const std::optional<std::string>& wrong, GuiCommands& commands) {
  const PlayingView& playing = model.playing;
  const bool connecting = playing.activity == Activity::Connecting;
  const bool paused = playing.activity == Activity::Paused;
  const bool moves = connecting || paused || playing.activity == Activity::Playing;
  const bool running = !playing.local && moves;
  // What is mistyped may be corrected while it is tried, and who waits for a server that was lost
  // may try it now.
  const bool corrected = form.settings != model.remote_settings;
  const bool lost = running && !playing.detail.empty();
  const bool may_connect = (!running || corrected || lost) && !wrong;
  const bool pressed = wide_button(tr("play.connect"), 0, 3, may_connect, may_connect);
  tip(tr("tip.connect"));
  if ((pressed && may_connect) || (entered && !wrong)) commands.push_back(Connect{form.settings});
  if (wide_button(paused ? tr("play.resume") : tr("play.pause"), 1, 3, moves && !connecting)) {
    if (paused) {
      commands.push_back(Resume{});
    } else {
      commands.push_back(Pause{});
    }
  }
  tip(paused ? tr("tip.resume") : tr("tip.pause"));
  const bool stopped = playing.local && paused && model.local.position == Duration::zero();
  if (wide_button(tr("play.stop"), 2, 3, moves && !stopped)) commands.push_back(Stop{});
  tip(tr("tip.stop"));
}

/// The choice of gui::Behind, and its numbers.
void behind_server(const Look& look, RemoteSettings& settings) {
  label(look, tr("play.behind"), tr("tip.behind"));
  const std::array<Word, 4> ways = {{{tr("play.behind_sets"), tr("tip.behind_sets")},
                                     {tr("play.behind_live"), tr("tip.behind_live")},
                                     {tr("play.behind_auto"), tr("tip.behind_auto")},
                                     {tr("play.behind_time"), tr("tip.behind_time")}}};
  int way = static_cast<int>(settings.behind);
  if (choice("behind", ways, way)) settings.behind = static_cast<Behind>(way);
  if (settings.behind == Behind::Time) {
    label(look, tr("play.behind_ms"), tr("tip.behind_time"));
    static_cast<void>(number_field("##behindms", settings.behind_ms, {.near = 50, .far = 500}));
  }
  if (settings.behind != Behind::Sets) return;
  // Their limits are checked by problem().
  number_row(look, tr("play.buffer"), "##buffer", settings.buffer, {}, tr("tip.buffer"));
  number_row(look, tr("play.playout"), "##playout", settings.playout, {}, tr("tip.playout"));
  number_row(look, tr("play.threshold"), "##threshold", settings.threshold_percent, {},
             tr("tip.threshold"));
}

/// The path of a file, typed or chosen in the dialog.
void path(const Look& look, const char* name, std::span<char> text, const char* help,
          Purpose purpose, GuiCommands& commands) {
  label(look, name, help);
  ImGui::PushID(name);
  leave_room_to_choose(look);
  ImGui::InputTextWithHint("##path", tr("play.path_hint"), text.data(), text.size());
  tip(help);
  if (choose_button(look)) commands.push_back(Browse{purpose});
  ImGui::PopID();
}

/// Puts what was chosen in the dialog since the last frame into its field.
void take_chosen(const std::string& chosen, std::string& taken, std::span<char> text) {
  if (chosen == taken) return;
  taken = chosen;
  if (!chosen.empty()) set_text(text, chosen);
}

/// How to connect to the server. Initially folded. Takes effect with the next Connect.
void next_connection(const Look& look, const GuiModel& model, RemoteForm& form,
                     GuiCommands& commands) {
  const bool open = foldable(tr("play.next_connection"));
  tip(tr("tip.connection"));
  if (!open) return;
  RemoteSettings& settings = form.settings;
  label(look, tr("play.protection"), tr("tip.tls"));
  if (ImGui::Checkbox(tr("play.tls"), &settings.tls)) set_text(form.address, server_text(settings));
  tip(tr("tip.tls"));
  ImGui::BeginDisabled(!settings.tls);
  take_chosen(model.credentials.authorities, form.chosen.authorities, form.authorities_file);
  path(look, tr("play.authorities_file"), form.authorities_file, tr("tip.authorities"),
       Purpose::AuthoritiesFile, commands);
  ImGui::EndDisabled();
  settings.authorities_file = form.authorities_file.data();
  take_chosen(model.credentials.token, form.chosen.token, form.token_file);
  path(look, tr("play.token_file"), form.token_file, tr("tip.token"), Purpose::TokenFile, commands);
  settings.token_file = form.token_file.data();
  label(look, tr("play.when_lost"), tr("tip.again"));
  ImGui::Checkbox(tr("play.again"), &settings.reconnect);
  tip(tr("tip.again"));
  behind_server(look, settings);
  number_row(look, tr("play.speed_ms"), "##speed", settings.speed_ms, {}, tr("play.speed_help"));
  if (model.playing.timed && settings.speed_ms > 0) toned_text(Tone::Waiting, tr("play.timed"));
  quiet_text(tr("play.next_help"));
}

void server(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands) {
  // The table of AUs is last and may be far below.
  form.to_aus |= heading_with_button(look, tr("play.server"), "", tr("play.aus"), "jump",
                                     tr("play.to_aus_tip"));
  const bool entered = address(model, form);
  stream(look, model, form, commands);
  const auto wrong = form.wrong ? form.wrong : problem(form.settings);
  connect_buttons(model, form, entered, wrong, commands);
  if (wrong) quiet_text(*wrong);
  next_connection(look, model, form, commands);
}

/// A value that is only shown, in less space than one to set.
void said(const Look& look, const char* name, const std::string& value, const char* help = "") {
  quiet_text(name);
  tip(help);
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + 112 * look.scale);
  quiet_text(value.empty() ? "-" : value);
}

/// A chart that a click makes larger or smaller again. The panel is scrolled to what would not be
/// seen of the larger one, which is still under the pointer then.
void chart(const Look& look, std::span<const PlotLine> lines, float small, float large_height,
           const PlotScale& scale, bool& large) {
  const bool clicked = plot(look, lines, (large ? large_height : small) * look.scale, scale);
  if (clicked) large = !large;
  if (pointed_at()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  tip(large ? tr("play.smaller") : tr("play.larger"));
  if (!clicked || !large) return;
  // The room that it takes from the next frame on.
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - spacing);
  ImGui::Dummy(ImVec2(1, (large_height - small) * look.scale));
  const float end = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
  const float hidden = ImGui::GetItemRectMax().y + spacing - end;
  if (hidden > 0) ImGui::SetScrollY(ImGui::GetScrollY() + hidden);
}

/// How many sets waited in the Receiver buffer. Small it has room for the scale alone.
void fill_chart(const Look& look, const PlayingView& playing, bool& large) {
  const BufferBar& buffer = playing.receiver;
  const std::size_t top = fill_scale(playing.receiver_history, buffer);
  const float enlarged = static_cast<float>(buffer.capacity) / static_cast<float>(top);
  std::vector<float> values = playing.receiver_history;
  for (float& value : values) value *= enlarged;
  PlotScale scale;
  scale.mark = enlarged * static_cast<float>(buffer.threshold_percent) / 100;
  if (!large) {
    scale.begin = tr("play.sets_range", top);  // where no mark goes through it
  } else {
    scale.top = tr("play.sets", top);
    if (scale.mark > 0) scale.mark_text = tr("play.begins_at");
    scale.begin = tr("play.ago_30");
    scale.end = tr("play.now");
  }
  const PlotLine line{&values, ImGui::GetColorU32(ImGuiCol_PlotLines)};
  chart(look, {&line, 1}, 34, 160, scale, large);
}

void buffers(const Look& look, const GuiModel& model, bool& large) {
  heading(look, tr("play.buffers"), tr("tip.buffers"));
  const PlayingView& playing = model.playing;
  buffer_bar(look, tr("play.receiver"), playing.receiver, tr("tip.receiver"));
  buffer_bar(look, tr("play.playout"), playing.playout, tr("tip.playout"));
  // Always as many rows: no control moves when a connection comes or goes.
  label(look, tr("play.last_30"), tr("tip.last_30"));
  fill_chart(look, playing, large);
  said(look, tr("play.received"), playing.in, tr("tip.received"));
  said(look, tr("play.sent"), playing.out, tr("tip.sent"));
  said(look, tr("play.protocol"), playing.protocol, tr("tip.protocol"));
  said(look, tr("play.delay"), playing.delay, tr("tip.delay"));
}

/// The strongest AUs over the last half minute, each with its colour and its number beside it; a
/// click makes it larger, with their names.
void intensities(const Look& look, const GuiModel& model, bool& large) {
  const PlayingView& playing = model.playing;
  if (playing.au_history.empty()) return;
  constexpr float kSmall = 96;
  constexpr float kLarge = 260;
  std::vector<PlotLine> lines;
  for (std::size_t i = 0; i < playing.au_history.size(); ++i) {
    const AuTrace& trace = playing.au_history[i];
    lines.push_back(
        {&trace.values, colour_of_line(i), std::to_string(trace.number), static_cast<int>(i)});
  }
  quiet_text(tr("play.strongest"));
  chart(look, lines, kSmall, kLarge, {}, large);
  if (!large) return;
  for (std::size_t i = 0; i < playing.au_history.size(); ++i) {
    const int number = playing.au_history[i].number;
    const std::string text = std::to_string(number) + "  " + au_name_of(model, number);
    line_name(look, static_cast<int>(i), text);
  }
}

void animation(const Look& look, const GuiModel& model, GuiCommands& commands) {
  heading(look, tr("play.animation"), tr("tip.animation"));
  AnimationSettings settings = model.animation;
  bool changed = false;
  label(look, tr("play.mixer"), tr("tip.mixer"));
  const std::array<Word, 2> mixers = {
      {{tr("play.maximum"), tr("tip.maximum")}, {tr("play.average"), tr("tip.average")}}};
  int mixer = settings.mixer == face::Mixer::Average ? 1 : 0;
  if (choice("mixer", mixers, mixer)) {
    settings.mixer = mixer == 1 ? face::Mixer::Average : face::Mixer::Maximum;
    changed = true;
  }
  changed |= in_between(look, "interpolation", settings.interpolation);
  label(look, tr("play.rules"), tr("tip.rules"));
  const auto found = std::find(kRules.begin(), kRules.end(), settings.rules);
  const std::array<Word, 3> words = {{{kRules[0], tr("tip.rules_facs")},
                                      {kRules[1], tr("tip.rules_kumar")},
                                      {tr("play.no_rules"), tr("tip.no_rules")}}};
  int rules = found == kRules.end() ? -1 : static_cast<int>(found - kRules.begin());
  if (choice("rules", words, rules)) {
    settings.rules = kRules[static_cast<std::size_t>(rules)];
    changed = true;
  }
  if (found == kRules.end()) quiet_text(tr("play.rules_from", settings.rules));
  if (changed) commands.push_back(ChangeAnimation{settings});
}

void action_units(const Look& look, const GuiModel& model, RemoteForm& form) {
  if (std::exchange(form.to_aus, false)) ImGui::SetScrollHereY(0);
  heading(look, tr("play.aus"), tr("tip.au"));
  intensities(look, model, form.large_chart);
  const bool made = model.editor.active || model.composer.active;
  const std::vector<AuRow>& rows =
      made ? model.playing.aus
           : form.aus.with(model.playing.aus,
                           model.local.open ? model.local.name : model.playing.stream);
  if (rows.empty()) {
    quiet_text(made                             ? tr("play.made_without")
               : model.playing.keyframe.empty() ? tr("play.none_yet")
                                                : tr("play.neutral_face"));
    return;
  }
  const AuTableWords of_stream{tr("play.au_received"), tr("tip.au_received"), tr("play.au_legend"),
                               tr("tip.au_shown")};
  const AuTableWords of_made{tr("expression.asked"), tr("tip.au_asked"), tr("expression.legend"),
                             tr("tip.au_blended")};
  au_table(look, made ? of_made : of_stream, rows);
}

/// Opens stream files, also those that were opened before.
void file_part(const GuiModel& model, GuiCommands& commands) {
  if (wide_button(tr("button.open_file"), 0, 2, true))
    commands.push_back(Browse{Purpose::PlayStream});
  tip(tr("play.open_tip"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(model.recent_files.empty());
  if (ImGui::BeginCombo("##files", tr("play.recent"))) {
    for (const std::string& file : model.recent_files) {
      if (list_item(file, false)) commands.push_back(OpenStream{file});
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
}

}  // namespace

void remote_panel(const Look& look, const GuiModel& model, RemoteForm& form,
                  GuiCommands& commands) {
  if (!form.filled) fill_form(model.remote_settings, form);
  server(look, model, form, commands);
  file_part(model, commands);
  record_part(look, model, form.record, commands);
  sound_part(look, model, commands);
  if (!model.playing.local) buffers(look, model, form.large_buffer);
  animation(look, model, commands);
  curves_part(look, model, form.curves, commands);
  // Last: it grows while it plays.
  action_units(look, model, form);
}

}  // namespace aucast::gui
