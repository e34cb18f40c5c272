#include "client/app/player_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "client/app/help_text.h"
#include "common/command_line.h"
#include "common/text.h"

namespace aucast::app {
namespace {

/// What the command line binds before it is turned into typed options.
struct Raw {
  int speed_ms = 0;
  int fps = 0;
  std::string buffer = "100";
  double hold_s = 5;
  int playout = 30;
  int live_delay_ms = 300;
  double connect_timeout_s = 10;
  std::string size;  ///< empty: the command's own
  std::string background;
  std::string show;
  std::string protocol = "auto";
  std::string blink;
  std::uint64_t idle_seed = 0;
  std::vector<std::string> muscles;
  int verbose = 0;
  bool help = false;
  bool version = false;
};

constexpr int kSizeMax = 8192;

void add_common(CLI::App& cli, PlayerOptions& options, Raw& raw) {
  cli.set_help_flag();  // ours: a page that fits the screen
  cli.add_flag("-h,--help", raw.help);
  cli.add_flag("--version", raw.version);
  cli.add_option("--log-level", options.log_level);
  cli.add_flag("-v,--verbose", raw.verbose);
  cli.add_flag("-q,--quiet", options.quiet);
  cli.add_option("--data", options.face.data);
  cli.add_option("--rules", options.face.rules);
}

void add_face(CLI::App& cli, PlayerOptions& options, Raw& raw) {
  static const std::map<std::string, face::Mixer> kMixers{{"maximum", face::Mixer::Maximum},
                                                          {"average", face::Mixer::Average}};
  cli.add_option("--face", options.face.face);
  cli.add_option("--mixer", options.face.mixer)->transform(CLI::CheckedTransformer(kMixers));
  cli.add_option("--size", raw.size);
  cli.add_option("--background", raw.background);
  cli.add_option("--show", raw.show);
}

void add_playback(CLI::App& cli, PlayerOptions& options, Raw& raw) {
  using playback::Interpolation;
  static const std::map<std::string, Interpolation> kInterpolations{
      {"linear", Interpolation::Linear}, {"cosine", Interpolation::Cosine}};
  cli.add_flag("--headless", options.headless);
  cli.add_flag("--exit-at-end", options.exit_at_end);
  cli.add_flag("--no-config{false}", options.config);
  cli.add_option("--speed", raw.speed_ms)->check(CLI::Range(1, 1000));
  cli.add_option("--interpolation", options.playback.interpolation)
      ->transform(CLI::CheckedTransformer(kInterpolations));
  cli.add_option("--blink", raw.blink);
  cli.add_option("--idle", raw.idle_seed);
  cli.add_option("--frames", options.output.frames);
  cli.add_option("--record", options.output.record);
  cli.add_option("--sheet", options.output.sheet);
  cli.add_option("--stats", options.output.stats);
  cli.add_option("--fps", raw.fps)->check(CLI::Range(1, 240));
  cli.add_flag("--fast", options.output.fast);
}

void add_network(CLI::App& cli, PlayerOptions& options, Raw& raw) {
  cli.add_option("--buffer", raw.buffer);
  cli.add_option("--hold", raw.hold_s)->check(CLI::Range(0.0, 86400.0));
  cli.add_option("--playout", raw.playout)->check(CLI::Range(1, 10000));
  cli.add_option("--threshold", options.playback.buffers.threshold_percent)
      ->check(CLI::Range(1, 100));
  cli.add_option("--live-delay", raw.live_delay_ms)->check(CLI::Range(0, 60000));
  cli.add_flag("--live", options.playback.buffers.low_delay);
  net::SecurityOptions& security = options.playback.security_options;
  cli.add_flag("--tls", security.tls);
  cli.add_option("--tls-ca", security.files.authorities);
  cli.add_option("--tls-cert", security.files.certificate);
  cli.add_option("--tls-key", security.files.key);
  cli.add_option("--token-file", security.token);
  cli.add_flag("--insecure-token", security.insecure_token);
  cli.add_flag("--reconnect", options.playback.reconnect);
  cli.add_option("--stream", options.playback.stream);
  cli.add_option("--protocol", raw.protocol)->check(CLI::IsMember({"auto", "classic"}));
  cli.add_option("--connect-timeout", raw.connect_timeout_s)->check(CLI::Range(0.01, 86400.0));
}

void add_camera(CLI::App& cli, PlayerOptions& options) {
  cli.add_option("--camera", options.pose.camera)
      ->check(CLI::IsMember({"front", "three-quarter", "profile"}));
}

void add_gallery(CLI::App& cli, PlayerOptions& options) {
  cli.add_option("DIR", options.gallery.folder);
  cli.add_option("--only", options.gallery.only)
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false)
      ->check(CLI::IsMember(
          {"aus", "prototypes", "combinations", "appendix-a", "appendix-b", "sweeps", "coverage"}));
  cli.add_option("--sweep", options.gallery.sweeps)
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  add_camera(cli, options);
}

void add_pose(CLI::App& cli, PlayerOptions& options, Raw& raw) {
  cli.add_option("AUS", options.pose.aus);
  cli.add_option("--muscle", raw.muscles)->take_all()->expected(1)->allow_extra_args(false);
  cli.add_option("--expression", options.pose.expression);
  cli.add_option("--png", options.pose.png);
  cli.add_option("--obj", options.pose.obj);
  add_camera(cli, options);
  cli.add_flag("--list", options.pose.list);
}

Error usage(std::string text) {
  return {ErrorKind::Usage, std::move(text) + " (try --help)"};
}

Result<void> read_size(const std::string& text, OutputOptions& output) {
  const std::size_t cross = text.find('x');
  const char* const end = text.data() + text.size();
  if (cross != std::string::npos) {
    const char* const middle = text.data() + cross;
    const auto width = std::from_chars(text.data(), middle, output.width);
    const auto height = std::from_chars(middle + 1, end, output.height);
    const bool whole = width.ec == std::errc() && width.ptr == middle && height.ec == std::errc() &&
                       height.ptr == end;
    const bool in_range = output.width >= 1 && output.width <= kSizeMax && output.height >= 1 &&
                          output.height <= kSizeMax;
    if (whole && in_range) return {};
  }
  return usage("--size '" + escaped(text) + "' is not WIDTHxHEIGHT, each 1 to " +
               std::to_string(kSizeMax) + ", such as 800x600");
}

Result<void> read_background(const std::string& text, OutputOptions& output) {
  if (text.empty()) return {};
  std::uint32_t rgb = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, rgb, 16);
  if (text.size() != 6 || read.ec != std::errc() || read.ptr != end) {
    return usage("--background '" + escaped(text) + "' is not RRGGBB, such as 808080");
  }
  output.background = rgb;
  return {};
}

Result<void> read_layers(const std::string& text, OutputOptions& output) {
  if (text.empty()) return {};
  auto layers = view::parse_layers(text);
  if (!layers) return usage("--show: " + layers.error().message);
  output.layers = *layers;
  return {};
}

Result<void> read_muscles(const std::vector<std::string>& texts, PoseOptions& pose) {
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    float value = 0;
    const char* const end = text.data() + text.size();
    const char* const begin = equals == std::string::npos ? end : text.data() + equals + 1;
    const auto read = std::from_chars(begin, end, value);
    if (begin == end || read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) {
      return usage("--muscle '" + escaped(text) + "' is not NAME=VALUE, such as jaw=1.5");
    }
    pose.muscles.emplace_back(text.substr(0, equals), value);
  }
  return {};
}

template <typename Number>
bool read_whole(std::string_view text, Number low, Number high, Number& out) {
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, out);
  return read.ec == std::errc() && read.ptr == end && out >= low && out <= high;
}

/// SEED[:INTERVAL_MS[:CLOSING_MS]]
Result<void> read_blink(const std::string& text, PlaybackOptions& playback) {
  playback::BlinkOptions blink;
  const auto parts = split(text, ':');
  constexpr auto kSeedMax = std::numeric_limits<std::uint64_t>::max();
  const bool good = parts.size() <= 3 &&
                    read_whole(parts[0], std::uint64_t{0}, kSeedMax, blink.seed) &&
                    (parts.size() < 2 || read_whole(parts[1], 500, 60'000, blink.interval_ms)) &&
                    (parts.size() < 3 || read_whole(parts[2], 25, 500, blink.closing_ms)) &&
                    blink.closing_ms * 6 <= blink.interval_ms;
  if (!good) {
    return usage("--blink '" + escaped(text) +
                 "' is not SEED[:INTERVAL[:CLOSING]]: a number, then ms, 500 to 60000 between "
                 "blinks and 25 to 500, at most a sixth of that, to close the lids");
  }
  playback.blink = blink;
  return {};
}

Error bad_buffer(const std::string& text) {
  return usage("--buffer '" + escaped(text) +
               "' is neither auto, nor a time of 0ms to 60000ms, nor 1 to 10000 sets");
}

/// Sets that there is room for when the buffer is measured by time.
constexpr int kBufferSetsByTime = 2000;

Result<void> read_buffers(const CLI::App& cli, const Raw& raw, playback::BufferOptions& buffers) {
  buffers.live_delay = Milliseconds(raw.live_delay_ms);
  buffers.adapt = cli.count("--live-delay") == 0;
  if (buffers.low_delay && !buffers.adapt) {
    return usage("--live takes the lowest delay and --live-delay another: give one of them");
  }
  int sets = kBufferSetsByTime;
  if (raw.buffer == "auto") {
    buffers.by_time = true;
  } else if (raw.buffer.ends_with("ms")) {
    int time_ms = 0;
    if (!read_whole(raw.buffer.substr(0, raw.buffer.size() - 2), 0, 60'000, time_ms)) {
      return bad_buffer(raw.buffer);
    }
    if (buffers.low_delay) {
      return usage("--live takes the lowest delay and --buffer " + raw.buffer + " another");
    }
    if (!buffers.adapt) return usage("--live-delay and --buffer " + raw.buffer + " say the same");
    buffers.by_time = true;
    buffers.adapt = false;
    buffers.live_delay = Milliseconds(time_ms);
  } else if (!read_whole(raw.buffer, 1, 10'000, sets)) {
    return bad_buffer(raw.buffer);
  }
  buffers.receiver_capacity = static_cast<std::size_t>(sets);
  buffers.playout_capacity = static_cast<std::size_t>(std::min(raw.playout, sets));
  if (raw.playout > sets && cli.count("--playout") > 0) {
    return usage("--playout " + std::to_string(raw.playout) + " is larger than --buffer " +
                 std::to_string(sets));
  }
  return {};
}

/// Turns what was bound into typed options and checks what one option alone cannot tell.
Result<void> settle(const CLI::App& cli, const Raw& raw, PlayerOptions& options) {
  if (options.quiet) options.log_level = "error";
  if (raw.verbose == 1) options.log_level = "info";
  if (raw.verbose > 1) options.log_level = "debug";
  const std::string own_size = options.command == Command::Gallery ? "300x375" : "800x600";
  auto size = read_size(raw.size.empty() ? own_size : raw.size, options.output);
  if (!size) return size;
  options.output.size_given = !raw.size.empty();
  if (auto behind = read_background(raw.background, options.output); !behind) return behind;
  if (auto layers = read_layers(raw.show, options.output); !layers) return layers;
  if (auto muscles = read_muscles(raw.muscles, options.pose); !muscles) return muscles;
  if (raw.speed_ms != 0) options.playback.speed = Milliseconds(raw.speed_ms);
  if (raw.fps != 0) options.output.fps = raw.fps;
  if (options.command == Command::Watch || options.command == Command::Play) {
    if (cli.count("--idle") > 0) {
      options.playback.idle_seed = raw.idle_seed;
      options.playback.blink = playback::BlinkOptions{raw.idle_seed};
    }
    if (cli.count("--blink") > 0) {
      if (auto blink = read_blink(raw.blink, options.playback); !blink) return blink;
    }
    if (auto buffers = read_buffers(cli, raw, options.playback.buffers); !buffers) return buffers;
    if (options.output.pictures()) options.output.fast = true;
    if (options.output.fast) options.headless = true;
    if (options.output.fast && options.playback.buffers.low_delay) {
      return usage("--live is for watching; --fast and pictures run on the film clock");
    }
  }
  options.playback.classic = raw.protocol == "classic";
  options.playback.hold = Milliseconds(std::llround(raw.hold_s * 1000));
  options.playback.connect_timeout =
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(raw.connect_timeout_s));
  return {};
}

Result<void> check_security(const PlaybackOptions& options) {
  const net::SecurityOptions& security = options.security_options;
  if (security.files.certificate.empty() != security.files.key.empty()) {
    return usage("--tls-cert and --tls-key go together");
  }
  if (options.classic && !security.token.empty()) {
    return usage("--token-file needs a hello, which --protocol classic never sends");
  }
  return {};
}

Result<void> check_required(const PlayerOptions& options) {
  if (auto secure = check_security(options.playback); !secure) return secure;
  switch (options.command) {
    case Command::Watch:
      if (options.headless && options.playback.endpoint.empty()) {
        return usage("--headless needs HOST[:PORT], or play FILE");
      }
      if (options.list && options.playback.endpoint.empty()) {
        return usage("--list needs HOST[:PORT]");
      }
      if (options.list && options.playback.classic) {
        return usage("--list asks what --protocol classic cannot");
      }
      break;
    case Command::Play:
      if (options.playback.file.empty()) return usage("play needs a stream FILE");
      break;
    case Command::Rules:
      if (options.pose.aus.empty()) return usage("rules needs a set of AUs, such as 1,6,12");
      break;
    case Command::Gallery:
      if (options.gallery.folder.empty()) return usage("gallery needs a folder DIR to write to");
      break;
    case Command::Pose:
    case Command::Help:
      break;
  }
  return {};
}

}  // namespace

Result<PlayerOptions> parse_player_options(std::vector<std::string> arguments) {
  static const std::map<std::string, Command> kCommands{{"play", Command::Play},
                                                        {"pose", Command::Pose},
                                                        {"rules", Command::Rules},
                                                        {"gallery", Command::Gallery}};
  PlayerOptions options;
  Raw raw;
  std::string page;
  if (!arguments.empty()) {
    if (const auto found = kCommands.find(arguments.front()); found != kCommands.end()) {
      options.command = found->second;
      page = found->first;
      arguments.erase(arguments.begin());
    }
  }
  CLI::App cli;
  add_common(cli, options, raw);
  switch (options.command) {
    case Command::Watch:
      add_face(cli, options, raw);
      add_playback(cli, options, raw);
      add_network(cli, options, raw);
      cli.add_option("HOST", options.playback.endpoint);
      cli.add_flag("--list", options.list);
      break;
    case Command::Play:
      add_face(cli, options, raw);
      add_playback(cli, options, raw);
      add_network(cli, options, raw);  // accepted, so that both commands take the same options
      cli.add_option("FILE", options.playback.file);
      break;
    case Command::Pose:
      add_face(cli, options, raw);
      add_pose(cli, options, raw);
      break;
    case Command::Rules:
      cli.add_option("AUS", options.pose.aus);
      cli.add_flag("--explain", options.pose.explain);
      break;
    case Command::Gallery:
      add_face(cli, options, raw);
      add_gallery(cli, options);
      break;
    case Command::Help:
      break;
  }
  if (auto parsed = parse_command_line(cli, std::move(arguments)); !parsed) return parsed.error();
  if (raw.help || raw.version) {
    options.command = Command::Help;
    options.text = raw.help ? std::string(help_text(page)) : version_text();
    return options;
  }
  for (const CLI::Option* option : cli.get_options()) {
    if (option->count() > 0) options.given.insert(option->get_name());
  }
  if (auto settled = settle(cli, raw, options); !settled) return settled.error();
  if (auto complete = check_required(options); !complete) return complete.error();
  return options;
}

}  // namespace aucast::app
