#include "client/gui/storage/kept_settings.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>
#include <vector>

#include "common/files.h"
#include "common/text.h"
#include "common/toml_reader.h"
#include "common/toml_writer.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFileMax = std::size_t{1} << 20U;
/// Broken files that are kept.
constexpr int kBrokenMax = 5;
constexpr std::array<std::string_view, 2> kMixers = {"maximum", "average"};
constexpr std::array<std::string_view, 2> kInterpolations = {"linear", "cosine"};
constexpr std::array<std::string_view, 5> kGrounds = {"studio", "black", "grey", "white", "none"};

/// What the tables of a file share.
struct Reading {
  std::string file;
  std::vector<std::string> left_out{};
  Problems problems{file};

  /// Whether nothing is wrong with what was read since the last call; else that is left out.
  [[nodiscard]] bool good() {
    const auto result = std::exchange(problems, Problems(file)).result();
    if (!result) left_out.push_back(result.error().message);
    return result.has_value();
  }
};

/// Fields that the file does not have, or has with a wrong value, keep their values.
class Fields : public TableReader {
 public:
  Fields(const TomlValue& table, Reading& reading)
      : TableReader(table, reading.problems), reading_(reading) {}

  void take(std::string_view key, int& value, int low, int high) {
    take(value, integer_or(key, value, low, high));
  }
  void take(std::string_view key, bool& value) { take(value, boolean_or(key, value)); }
  void take(std::string_view key, std::string& value) { take(value, text_or(key, value)); }
  template <typename Enum, std::size_t N>
  void take(std::string_view key, Enum& value, const std::array<std::string_view, N>& words) {
    take(value, static_cast<Enum>(word_or(key, static_cast<std::size_t>(value), words)));
  }
  void take(std::string_view key, std::vector<std::string>& values) { take(values, texts(key)); }
  void leave_out(std::string_view key, const std::string& why) {
    wrong(key, why);
    static_cast<void>(reading_.good());
  }
  void finish() {
    TableReader::finish();
    static_cast<void>(reading_.good());
  }

 private:
  template <typename T>
  void take(T& value, T read) {
    if (reading_.good()) value = std::move(read);
  }

  Reading& reading_;
};

/// The names of gui::Behind, in its order.
constexpr std::array<std::string_view, 4> kBehind{"sets", "live", "auto", "time"};

void read_remote(Fields fields, KeptSettings& settings) {
  RemoteSettings& remote = settings.remote;
  fields.take("address", remote.address);
  fields.take("port", remote.port, 1, RemoteSettings::kPortMax);
  fields.take("buffer", remote.buffer, 1, RemoteSettings::kSetsMax);
  fields.take("playout", remote.playout, 1, RemoteSettings::kSetsMax);
  fields.take("threshold_percent", remote.threshold_percent, 1, 100);
  fields.take("behind", remote.behind, kBehind);
  fields.take("behind_ms", remote.behind_ms, 0, RemoteSettings::kBehindMsMax);
  fields.take("speed_ms", remote.speed_ms, 0, RemoteSettings::kSpeedMsMax);
  fields.take("reconnect", remote.reconnect);
  fields.take("stream", remote.stream);
  fields.take("tls", remote.tls);
  fields.take("tls_ca", remote.authorities_file);
  fields.take("token_file", remote.token_file);
  std::vector<std::string> others;
  fields.take("others", others);
  for (const std::string& other : others) {
    if (auto endpoint = protocol::parse_endpoint(other)) {
      remote.others.push_back(*std::move(endpoint));
    } else {
      fields.leave_out("others", endpoint.error().message);
    }
  }
  fields.take("recent", settings.recent);
  if (settings.recent.size() > kRecentMax) settings.recent.resize(kRecentMax);
  const RemoteSettings usual;
  if (remote.playout > remote.buffer) {
    RemoteSettings buffers = usual;  // the address may be wrong as well
    buffers.buffer = remote.buffer;
    buffers.playout = remote.playout;
    fields.leave_out("playout", *problem(buffers));
    remote.buffer = usual.buffer;
    remote.playout = usual.playout;
  }
  if (const auto wrong = problem(remote)) {
    fields.leave_out("address", *wrong);
    remote.address = usual.address;
    remote.others.clear();
  }
  fields.finish();
}

void read_files(Fields fields, KeptSettings& settings) {
  fields.take("recent", settings.recent_files);
  if (settings.recent_files.size() > kRecentMax) settings.recent_files.resize(kRecentMax);
  fields.take("own_folder", settings.own_folder);
  fields.finish();
}

void read_table(Fields fields, std::vector<KnownTable>& tables) {
  KnownTable known;
  fields.take("file", known.file);
  TableSettings& table = known.settings;
  fields.take("fps", table.fps, 0, kTableFpsMax);
  fields.take("rate", table.rate, 0, 100);
  fields.take("gain_percent", table.gain_percent, 0, kTableGainPercentMax);
  fields.take("neutral_s", table.neutral_s, 0, kTableNeutralMax);
  fields.finish();
  if (tables.size() < kKnownTablesMax) tables.push_back(std::move(known));
}

void read_face(Fields fields, KeptSettings& settings) {
  fields.take("folder", settings.face);
  fields.finish();
}

void read_animation(Fields fields, KeptSettings& settings) {
  fields.take("mixer", settings.animation.mixer, kMixers);
  fields.take("rules", settings.animation.rules);
  fields.take("interpolation", settings.animation.interpolation, kInterpolations);
  fields.take("transition_frames", settings.transition.frames, 1, TransitionSettings::kFramesMax);
  fields.take("transition_frame_ms", settings.transition.frame_ms, 1,
              TransitionSettings::kFrameMsMax);
  fields.take("transition_cosine", settings.transition.cosine);
  fields.finish();
}

void read_rendering(Fields fields, RenderingSettings& rendering) {
  using Blink = playback::BlinkOptions;
  std::string layers = view::format_layers(rendering.layers);
  fields.take("show", layers);
  if (layers.empty()) {
    rendering.layers.textured = false;
  } else if (auto parsed = view::parse_layers(layers)) {
    rendering.layers = *parsed;
  } else {
    fields.leave_out("show", parsed.error().message);
  }
  fields.take("background", rendering.ground, kGrounds);
  fields.take("light_yaw_deg", rendering.light_yaw_deg, -kLightYawMaxDeg, kLightYawMaxDeg);
  fields.take("light_pitch_deg", rendering.light_pitch_deg, -kLightPitchMaxDeg, kLightPitchMaxDeg);
  fields.take("light_percent", rendering.light_percent, 0, kLightPercentMax);
  fields.take("blinking", rendering.blinking);
  fields.take("blink_interval_ms", rendering.blink.interval_ms, Blink::kIntervalMinMs,
              Blink::kIntervalMaxMs);
  fields.take("blink_closing_ms", rendering.blink.closing_ms, Blink::kClosingMinMs,
              Blink::kClosingMaxMs);
  fields.take("blink_interpolation", rendering.blink.interpolation, kInterpolations);
  int seed = shown_seed(rendering.blink.seed);
  fields.take("blink_seed", seed, 0, kSeedShownMax);
  rendering.blink.seed = static_cast<std::uint64_t>(seed);
  fields.finish();
}

void read_pictures(Fields fields, PictureSettings& pictures) {
  fields.take("folder", pictures.folder);
  fields.take("name", pictures.pattern);
  fields.take("width", pictures.width, 0, kPictureSideMax);
  fields.take("height", pictures.height, 0, kPictureSideMax);
  if (const auto name = picture_name(pictures.pattern, {}, 1); !name) {
    fields.leave_out("name", name.error().message);
    pictures.pattern = PictureSettings().pattern;
  }
  fields.finish();
}

void read_display(Fields fields, DisplaySettings& display) {
  fields.take("language", display.language);
  fields.take("text_percent", display.text_percent, kTextPercentMin, kTextPercentMax);
  fields.finish();
}

void read_sound(Fields fields, int& volume) {
  fields.take("volume", volume, 0, 100);
  fields.finish();
}

/// Renames the file to FILE.broken, FILE.broken.2 and so on, whichever there is not yet. Empty: it
/// stays where it is.
fs::path put_aside(const fs::path& file) {
  for (int number = 1; number <= kBrokenMax; ++number) {
    fs::path aside = file;
    aside += number == 1 ? ".broken" : ".broken." + std::to_string(number);
    std::error_code failed;
    if (fs::exists(fs::symlink_status(aside, failed))) continue;
    fs::rename(file, aside, failed);
    return failed ? fs::path() : aside;
  }
  return {};
}

std::string line(std::string_view key, int value) {
  return toml_line(key, std::to_string(value));
}
std::string line(std::string_view key, bool value) {
  return toml_line(key, value ? "true" : "false");
}
std::string line(std::string_view key, const std::string& value) {
  return toml_line(key, toml_text(value));
}
template <typename Enum, std::size_t N>
std::string line(std::string_view key, Enum value, const std::array<std::string_view, N>& words) {
  return toml_line(key, toml_text(words[static_cast<std::size_t>(value)]));
}

}  // namespace

Result<fs::path> settings_file(const char* xdg_config_home, const char* home) {
  const auto base = users_folder(xdg_config_home, home, ".config");
  if (!base) {
    return Error{ErrorKind::Failed,
                 "no place for settings: set HOME or XDG_CONFIG_HOME to a folder"};
  }
  return *base / "aucast" / "face-player.toml";
}

Result<ParsedSettings> parse_settings(std::string_view text, const std::string& file) {
  const auto document = parse_toml(text, file);
  if (!document) return document.error();
  KeptSettings settings;
  Reading reading{file};
  Fields sections(*document, reading);
  const auto section = [&](std::string_view name, const auto& read) {
    const TomlValue* const table = sections.table_if(name);
    if (reading.good() && table != nullptr) read(Fields(*table, reading));
  };
  section("remote", [&](Fields fields) { read_remote(std::move(fields), settings); });
  section("files", [&](Fields fields) { read_files(std::move(fields), settings); });
  const auto tables = sections.tables("table");
  if (reading.good()) {
    for (const TomlValue* table : tables) read_table({*table, reading}, settings.tables);
  }
  section("face", [&](Fields fields) { read_face(std::move(fields), settings); });
  section("animation", [&](Fields fields) { read_animation(std::move(fields), settings); });
  section("rendering",
          [&](Fields fields) { read_rendering(std::move(fields), settings.rendering); });
  section("window", [&](Fields fields) { read_display(std::move(fields), settings.display); });
  section("pictures", [&](Fields fields) { read_pictures(std::move(fields), settings.pictures); });
  section("sound", [&](Fields fields) { read_sound(std::move(fields), settings.volume); });
  sections.finish();
  return ParsedSettings{std::move(settings), std::move(reading.left_out)};
}

std::string format_settings(const KeptSettings& settings) {
  const RemoteSettings& remote = settings.remote;
  std::vector<std::string> others;
  for (const protocol::Endpoint& other : remote.others) {
    others.push_back(other.host.find(':') == std::string::npos ? other.host
                                                               : "[" + other.host + "]");
    others.back() += ":" + std::to_string(other.port);
  }
  std::string text =
      "# What face-player's window remembers. It is written when the window closes, and when a\n"
      "# file, a server or a face was opened; options of the command line come first, --no-config "
      "leaves\n"
      "# it alone.\n\n[remote]\n";
  text += line("address", remote.address) + line("port", remote.port) +
          toml_line("others", toml_texts(others)) +
          toml_line("recent", toml_texts(settings.recent)) + line("buffer", remote.buffer) +
          line("playout", remote.playout) + line("threshold_percent", remote.threshold_percent) +
          line("behind", std::string(kBehind[static_cast<std::size_t>(remote.behind)])) +
          line("behind_ms", remote.behind_ms) + line("speed_ms", remote.speed_ms) +
          line("reconnect", remote.reconnect) + line("stream", remote.stream) +
          line("tls", remote.tls) + line("tls_ca", remote.authorities_file) +
          line("token_file", remote.token_file);
  text += "\n[files]\n" + toml_line("recent", toml_texts(settings.recent_files)) +
          line("own_folder", settings.own_folder);
  for (const KnownTable& known : settings.tables) {
    const TableSettings& table = known.settings;
    text += "\n[[table]]\n" + line("file", known.file) + line("fps", table.fps) +
            line("rate", table.rate) + line("gain_percent", table.gain_percent) +
            line("neutral_s", table.neutral_s);
  }
  text += "\n[face]\n" + line("folder", settings.face);
  text += "\n[animation]\n";
  text += line("mixer", settings.animation.mixer, kMixers) +
          line("rules", settings.animation.rules) +
          line("interpolation", settings.animation.interpolation, kInterpolations) +
          line("transition_frames", settings.transition.frames) +
          line("transition_frame_ms", settings.transition.frame_ms) +
          line("transition_cosine", settings.transition.cosine);
  const RenderingSettings& rendering = settings.rendering;
  text += "\n[rendering]\n";
  text += line("show", view::format_layers(rendering.layers)) +
          line("background", rendering.ground, kGrounds) +
          line("light_yaw_deg", rendering.light_yaw_deg) +
          line("light_pitch_deg", rendering.light_pitch_deg) +
          line("light_percent", rendering.light_percent) + line("blinking", rendering.blinking) +
          line("blink_interval_ms", rendering.blink.interval_ms) +
          line("blink_closing_ms", rendering.blink.closing_ms) +
          line("blink_interpolation", rendering.blink.interpolation, kInterpolations) +
          line("blink_seed", shown_seed(rendering.blink.seed));
  const PictureSettings& pictures = settings.pictures;
  text += "\n[pictures]\n" + line("folder", pictures.folder) + line("name", pictures.pattern) +
          line("width", pictures.width) + line("height", pictures.height);
  text += "\n[window]\n" + line("language", settings.display.language) +
          line("text_percent", settings.display.text_percent);
  text += "\n[sound]\n" + line("volume", settings.volume);
  return text;
}

void remember_address(std::vector<std::string>& recent, const RemoteSettings& settings) {
  remember_file(recent, address_text(settings));
}

void remember_file(std::vector<std::string>& recent, const std::string& file) {
  std::erase(recent, file);
  recent.insert(recent.begin(), file);
  if (recent.size() > kRecentMax) recent.resize(kRecentMax);
}

LoadedSettings load_settings(const fs::path& file) {
  LoadedSettings loaded;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return loaded;
  const auto text = read_file(file, kFileMax);
  auto parsed = text ? parse_settings(*text, file.string()) : Result<ParsedSettings>(text.error());
  if (parsed) {
    loaded.settings = std::move(parsed->settings);
    loaded.left_out = std::move(parsed->left_out);
    return loaded;
  }
  // What could not be read may be in the best of order.
  const fs::path aside = text ? put_aside(file) : fs::path();
  loaded.may_write = !aside.empty();
  loaded.complaint =
      parsed.error().message + "; the usual settings are used, " +
      (loaded.may_write ? "that file is now " + aside.string() +
                              "; correct it and give it its old name to have them again"
                        : "and nothing will be written there; move that file away or remove it");
  return loaded;
}

Result<void> save_settings(const KeptSettings& settings, const fs::path& file) {
  std::error_code failed;
  fs::create_directories(file.parent_path(), failed);
  if (failed) {
    return Error{ErrorKind::Failed, "cannot make " +
                                        at_place(file.parent_path().string(), failed.message()) +
                                        "; XDG_CONFIG_HOME can name another folder"};
  }
  return write_file_atomically(file, format_settings(settings));
}

}  // namespace aucast::gui
