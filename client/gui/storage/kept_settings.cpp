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
/// The names of gui::Behind, in its order.
constexpr std::array<std::string_view, 4> kBehind{"sets", "live", "auto", "time"};

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

/// Writes fields as Fields reads them.
class Lines {
 public:
  void begin(std::string_view table) { text_.append("\n").append(table).append("\n"); }
  void take(std::string_view key, int value, int /*low*/, int /*high*/) {
    text_ += toml_line(key, std::to_string(value));
  }
  void take(std::string_view key, bool value) { text_ += toml_line(key, value ? "true" : "false"); }
  void take(std::string_view key, std::string_view value) {
    text_ += toml_line(key, toml_text(value));
  }
  template <typename Enum, std::size_t N>
  void take(std::string_view key, Enum value, const std::array<std::string_view, N>& words) {
    take(key, words[static_cast<std::size_t>(value)]);
  }
  void take(std::string_view key, const std::vector<std::string>& values) {
    text_ += toml_line(key, toml_texts(values));
  }
  [[nodiscard]] std::string text() { return std::move(text_); }

 private:
  std::string text_;
};

// === The tables, each with its fields in the order of the file. `io`: Fields, which read the
// settings, or Lines, which write them.

void remote_fields(auto& io, auto& settings, auto& others) {
  auto& remote = settings.remote;
  io.take("address", remote.address);
  io.take("port", remote.port, 1, RemoteSettings::kPortMax);
  io.take("others", others);
  io.take("recent", settings.recent);
  io.take("buffer", remote.buffer, 1, RemoteSettings::kSetsMax);
  io.take("playout", remote.playout, 1, RemoteSettings::kSetsMax);
  io.take("threshold_percent", remote.threshold_percent, 1, 100);
  io.take("behind", remote.behind, kBehind);
  io.take("behind_ms", remote.behind_ms, 0, RemoteSettings::kBehindMsMax);
  io.take("speed_ms", remote.speed_ms, 0, RemoteSettings::kSpeedMsMax);
  io.take("reconnect", remote.reconnect);
  io.take("stream", remote.stream);
  io.take("tls", remote.tls);
  io.take("tls_ca", remote.authorities_file);
  io.take("token_file", remote.token_file);
}

void file_fields(auto& io, auto& settings) {
  io.take("recent", settings.recent_files);
  io.take("own_folder", settings.own_folder);
}

void table_fields(auto& io, auto& known) {
  io.take("file", known.file);
  auto& table = known.settings;
  io.take("fps", table.fps, 0, kTableFpsMax);
  io.take("rate", table.rate, 0, 100);
  io.take("gain_percent", table.gain_percent, 0, kTableGainPercentMax);
  io.take("neutral_s", table.neutral_s, 0, kTableNeutralMax);
}

void animation_fields(auto& io, auto& settings) {
  io.take("mixer", settings.animation.mixer, kMixers);
  io.take("rules", settings.animation.rules);
  io.take("interpolation", settings.animation.interpolation, kInterpolations);
  auto& transition = settings.transition;
  io.take("transition_frames", transition.frames, 1, TransitionSettings::kFramesMax);
  io.take("transition_frame_ms", transition.frame_ms, 1, TransitionSettings::kFrameMsMax);
  io.take("transition_cosine", transition.cosine);
}

void rendering_fields(auto& io, auto& rendering, auto&& layers, auto&& seed) {
  using Blink = playback::BlinkOptions;
  io.take("show", layers);
  io.take("background", rendering.ground, kGrounds);
  io.take("light_yaw_deg", rendering.light_yaw_deg, -kLightYawMaxDeg, kLightYawMaxDeg);
  io.take("light_pitch_deg", rendering.light_pitch_deg, -kLightPitchMaxDeg, kLightPitchMaxDeg);
  io.take("light_percent", rendering.light_percent, 0, kLightPercentMax);
  io.take("blinking", rendering.blinking);
  auto& blink = rendering.blink;
  io.take("blink_interval_ms", blink.interval_ms, Blink::kIntervalMinMs, Blink::kIntervalMaxMs);
  io.take("blink_closing_ms", blink.closing_ms, Blink::kClosingMinMs, Blink::kClosingMaxMs);
  io.take("blink_interpolation", blink.interpolation, kInterpolations);
  io.take("blink_seed", seed, 0, kSeedShownMax);
}

void picture_fields(auto& io, auto& pictures) {
  io.take("folder", pictures.folder);
  io.take("name", pictures.pattern);
  io.take("width", pictures.width, 0, kPictureSideMax);
  io.take("height", pictures.height, 0, kPictureSideMax);
}

void display_fields(auto& io, auto& display) {
  io.take("language", display.language);
  io.take("text_percent", display.text_percent, kTextPercentMin, kTextPercentMax);
}

// === What reading checks beyond single fields.

void read_remote(Fields& fields, KeptSettings& settings) {
  RemoteSettings& remote = settings.remote;
  std::vector<std::string> others;
  remote_fields(fields, settings, others);
  for (const std::string& other : others) {
    if (auto endpoint = protocol::parse_endpoint(other)) {
      remote.others.push_back(*std::move(endpoint));
    } else {
      fields.leave_out("others", endpoint.error().message);
    }
  }
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
}

void read_rendering(Fields& fields, RenderingSettings& rendering) {
  std::string layers = view::format_layers(rendering.layers);
  int seed = shown_seed(rendering.blink.seed);
  rendering_fields(fields, rendering, layers, seed);
  rendering.blink.seed = static_cast<std::uint64_t>(seed);
  if (layers.empty()) {
    rendering.layers.textured = false;
  } else if (auto parsed = view::parse_layers(layers)) {
    rendering.layers = *parsed;
  } else {
    fields.leave_out("show", parsed.error().message);
  }
}

void read_pictures(Fields& fields, PictureSettings& pictures) {
  picture_fields(fields, pictures);
  if (const auto name = picture_name(pictures.pattern, {}, 1); !name) {
    fields.leave_out("name", name.error().message);
    pictures.pattern = PictureSettings().pattern;
  }
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
  const auto read = [&](const TomlValue& table, const auto& fields_of) {
    Fields fields(table, reading);
    fields_of(fields);
    fields.finish();
  };
  const auto section = [&](std::string_view name, const auto& fields_of) {
    const TomlValue* const table = sections.table_if(name);
    if (reading.good() && table != nullptr) read(*table, fields_of);
  };
  section("remote", [&](Fields& fields) { read_remote(fields, settings); });
  section("files", [&](Fields& fields) { file_fields(fields, settings); });
  if (settings.recent_files.size() > kRecentMax) settings.recent_files.resize(kRecentMax);
  const auto tables = sections.tables("table");
  for (const TomlValue* table : reading.good() ? tables : std::vector<const TomlValue*>()) {
    KnownTable known;
    read(*table, [&](Fields& fields) { table_fields(fields, known); });
    if (settings.tables.size() < kKnownTablesMax) settings.tables.push_back(std::move(known));
  }
  section("face", [&](Fields& fields) { fields.take("folder", settings.face); });
  section("animation", [&](Fields& fields) { animation_fields(fields, settings); });
  section("rendering", [&](Fields& fields) { read_rendering(fields, settings.rendering); });
  section("window", [&](Fields& fields) { display_fields(fields, settings.display); });
  section("pictures", [&](Fields& fields) { read_pictures(fields, settings.pictures); });
  section("sound", [&](Fields& fields) { fields.take("volume", settings.volume, 0, 100); });
  sections.finish();
  return ParsedSettings{std::move(settings), std::move(reading.left_out)};
}

std::string format_settings(const KeptSettings& settings) {
  std::vector<std::string> others;
  for (const protocol::Endpoint& other : settings.remote.others) {
    others.push_back(other.host.find(':') == std::string::npos ? other.host
                                                               : "[" + other.host + "]");
    others.back() += ":" + std::to_string(other.port);
  }
  Lines lines;
  lines.begin("[remote]");
  remote_fields(lines, settings, others);
  lines.begin("[files]");
  file_fields(lines, settings);
  for (const KnownTable& known : settings.tables) {
    lines.begin("[[table]]");
    table_fields(lines, known);
  }
  lines.begin("[face]");
  lines.take("folder", settings.face);
  lines.begin("[animation]");
  animation_fields(lines, settings);
  lines.begin("[rendering]");
  rendering_fields(lines, settings.rendering, view::format_layers(settings.rendering.layers),
                   shown_seed(settings.rendering.blink.seed));
  lines.begin("[pictures]");
  picture_fields(lines, settings.pictures);
  lines.begin("[window]");
  display_fields(lines, settings.display);
  lines.begin("[sound]");
  lines.take("volume", settings.volume, 0, 100);
  return "# What face-player's window remembers. It is written when the window closes, and when a\n"
         "# file, a server or a face was opened; options of the command line come first, "
         "--no-config leaves\n"
         "# it alone.\n" +
         lines.text();
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
