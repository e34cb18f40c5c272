#include "client/app/window/settings/window_settings.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "client/app/remote_options.h"
#include "client/net/remote_source.h"
#include "common/log.h"

namespace aucast::app {
namespace {

using gui::KeptSettings;

/// Copies the settings for which the command line had options from `from` to `to`, if `wanted` says
/// so.
template <typename Wanted>
void copy_given(const std::set<std::string>& given, const KeptSettings& from, KeptSettings& to,
                Wanted wanted) {
  const auto copy = [&](const char* option, auto member_of) {
    if (given.contains(option) && wanted(member_of)) member_of(to) = member_of(from);
  };
  copy("--buffer", [](auto& s) { return std::tie(s.remote.buffer); });
  for (const char* option : {"--buffer", "--live", "--live-delay"}) {
    copy(option, [](auto& s) { return std::tie(s.remote.behind); });
    copy(option, [](auto& s) { return std::tie(s.remote.behind_ms); });
  }
  copy("--playout", [](auto& s) { return std::tie(s.remote.playout); });
  copy("--threshold", [](auto& s) { return std::tie(s.remote.threshold_percent); });
  copy("--speed", [](auto& s) { return std::tie(s.remote.speed_ms); });
  copy("--reconnect", [](auto& s) { return std::tie(s.remote.reconnect); });
  copy("--stream", [](auto& s) { return std::tie(s.remote.stream); });
  copy("--tls", [](auto& s) { return std::tie(s.remote.tls); });
  copy("--tls-ca", [](auto& s) { return std::tie(s.remote.authorities_file); });
  copy("--token-file", [](auto& s) { return std::tie(s.remote.token_file); });
  copy("--mixer", [](auto& s) { return std::tie(s.animation.mixer); });
  copy("--rules", [](auto& s) { return std::tie(s.animation.rules); });
  copy("--interpolation", [](auto& s) { return std::tie(s.animation.interpolation); });
  copy("--show", [](auto& s) { return std::tie(s.rendering.layers); });
  copy("--language", [](auto& s) { return std::tie(s.display.language); });
  copy("--text-size", [](auto& s) { return std::tie(s.display.text_percent); });
  copy("--volume", [](auto& s) { return std::tie(s.volume); });
  for (const char* option : {"--idle", "--blink"}) {
    copy(option, [](auto& s) { return std::tie(s.rendering.blinking); });
    copy(option, [](auto& s) { return std::tie(s.rendering.blink.seed); });
  }
  copy("--blink", [](auto& s) { return std::tie(s.rendering.blink.interval_ms); });
  copy("--blink", [](auto& s) { return std::tie(s.rendering.blink.closing_ms); });
}

KeptSettings settings_of(const PlayerOptions& options) {
  KeptSettings settings;
  const PlaybackOptions& playback = options.playback;
  settings.remote.buffer = static_cast<int>(playback.buffers.receiver_capacity);
  settings.remote.playout = static_cast<int>(playback.buffers.playout_capacity);
  settings.remote.threshold_percent = playback.buffers.threshold_percent;
  if (playback.buffers.low_delay) settings.remote.behind = gui::Behind::Live;
  if (playback.buffers.by_time) {
    settings.remote.behind = playback.buffers.adapt ? gui::Behind::Auto : gui::Behind::Time;
    settings.remote.behind_ms = static_cast<int>(playback.buffers.live_delay.count());
  }
  if (playback.speed) settings.remote.speed_ms = static_cast<int>(playback.speed->count());
  settings.remote.reconnect = playback.reconnect;
  settings.remote.stream = playback.stream;
  settings.remote.tls = playback.security.tls;
  settings.animation = {options.face.mixer, options.face.rules, playback.interpolation};
  settings.display = options.display;
  settings.volume = options.sound.volume;
  settings.rendering.layers = options.output.layers;
  settings.rendering.blinking = playback.blink.has_value();
  settings.rendering.blink = playback.blink.value_or(settings.rendering.blink);
  return settings;
}

std::filesystem::path usual_file(const PlayerOptions& options) {
  if (options.headless || !options.config) return {};
  auto file = gui::settings_file(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
  return file ? *file : std::filesystem::path();
}

/// The first one; the others are in the log.
std::string left_out_words(const std::vector<std::string>& left_out) {
  const std::size_t more = left_out.size() - 1;
  return left_out.front() + (more == 0 ? "" : " (and " + std::to_string(more) + " more)") +
         "; the usual " + (more == 0 ? "setting is" : "settings are") + " used";
}

}  // namespace

WindowSettings WindowSettings::load(const PlayerOptions& options) {
  WindowSettings settings(options, usual_file(options));
  for (const std::string& one : settings.left_out_) {
    spdlog::warn("{}; the usual setting is used", one);
  }
  if (settings.left_out_.empty() && !settings.complaint_.empty()) {
    spdlog::warn("{}", settings.complaint_);
  }
  return settings;
}

WindowSettings::WindowSettings(const PlayerOptions& options, std::filesystem::path file)
    : file_(std::move(file)), given_(options.given) {
  if (!file_.empty()) {
    gui::LoadedSettings loaded = gui::load_settings(file_);
    kept_ = std::move(loaded.settings);
    complaint_ = std::move(loaded.complaint);
    left_out_ = std::move(loaded.left_out);
    if (!left_out_.empty()) complaint_ = left_out_words(left_out_);
    if (!loaded.may_write) file_.clear();
  }
  in_force_ = kept_;
  copy_given(given_, settings_of(options), in_force_, [](auto) { return true; });
  // One of the two was given and the other is the file's.
  in_force_.remote.playout = std::min(in_force_.remote.playout, in_force_.remote.buffer);
  if (const auto endpoint = net::parse_endpoint(options.playback.endpoint)) {
    in_force_.remote.address = endpoint->host;
    in_force_.remote.port = endpoint->port;
    in_force_.remote.others = options.playback.others;
    // The last ones were another server's.
    in_force_.remote.stream = options.playback.stream;
    in_force_.remote.tls = options.playback.security.tls;
    in_force_.remote.authorities_file.clear();
    in_force_.remote.token_file.clear();
  }
}

PlayerOptions WindowSettings::applied(PlayerOptions options) const {
  if (options.headless) return options;
  PlaybackOptions& playback = options.playback;
  const gui::RemoteSettings& remote = in_force_.remote;
  set_buffers(remote, playback.buffers);
  playback.speed.reset();
  if (remote.speed_ms > 0) playback.speed = Milliseconds(remote.speed_ms);
  playback.reconnect = remote.reconnect || !playback.others.empty();
  playback.interpolation = in_force_.animation.interpolation;
  options.face.mixer = in_force_.animation.mixer;
  options.face.rules = in_force_.animation.rules;
  if (!given_.contains("--face") && !in_force_.face.empty()) options.face.face = in_force_.face;
  return options;
}

Result<void> WindowSettings::keep(KeptSettings now) {
  if (file_.empty()) return {};
  // The server of the command line is kept once it has answered, as any other.
  const std::string server = gui::address_text(now.remote);
  const bool unheard = now.recent.empty() || now.recent.front() != server;
  if (unheard && server == gui::address_text(in_force_.remote)) {
    now.remote = gui::with_server_of(now.remote, kept_.remote);
  }
  copy_given(given_, kept_, now,
             [&](auto member_of) { return member_of(now) == member_of(in_force_); });
  if (now == kept_) return {};
  auto saved = gui::save_settings(now, file_);
  if (saved) kept_ = std::move(now);
  return saved;
}

}  // namespace aucast::app
