#include "server/transmitter_options.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "common/command_line.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// A day: longer waits for one answer are taken for a slip of the finger.
constexpr double kClientTimeoutMax = 86'400;

/// More than a process can have descriptors.
constexpr std::int64_t kMaxClientsMost = 1'000'000;

/// The words as they were typed. Numbers are read by ourselves, so that every message has one form.
struct Typed {
  std::vector<std::string> sources;
  std::string bind;
  std::string port;
  std::string keyframe;
  std::string classic_min;
  std::string client_timeout;
  std::string max_clients;
  std::string stats;
  std::string log_level;
  SourceWords source;
  bool help = false;
  bool version = false;
  bool loop = false;
  bool live = false;
  bool check = false;
  bool verbose = false;
  bool quiet = false;
};

Error usage(std::string message) {
  return {ErrorKind::Usage, std::move(message) + " (try --help)"};
}

void describe(CLI::App& app, Typed& typed) {
  app.set_help_flag();  // ours is made for one screen
  app.add_flag("-h,--help", typed.help);
  app.add_flag("--version", typed.version);
  app.add_option("SOURCE", typed.sources);
  app.add_option("--bind", typed.bind);
  app.add_option("--port", typed.port);
  app.add_option("--keyframe", typed.keyframe);
  app.add_option("--classic-min", typed.classic_min);
  app.add_option("--client-timeout", typed.client_timeout);
  app.add_option("--stats", typed.stats);
  app.add_option("--log-level", typed.log_level);
  app.add_option("--max-clients", typed.max_clients);
  describe_source_options(app, typed.source);
  app.add_flag("--loop", typed.loop);
  app.add_flag("--live", typed.live);
  app.add_flag("--check", typed.check);
  app.add_flag("-v,--verbose", typed.verbose);
  app.add_flag("-q,--quiet", typed.quiet);
}

template <typename T>
std::optional<T> number_of(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

/// Reads a whole number into `out` if the option was given; the message names it.
std::optional<Error> read_whole(std::string_view option, const std::string& text, std::int64_t low,
                                std::int64_t high, std::int64_t& out) {
  if (text.empty()) return std::nullopt;
  const auto value = number_of<std::int64_t>(text);
  if (value && *value >= low && *value <= high) {
    out = *value;
    return std::nullopt;
  }
  return usage(std::string(option) + " '" + escaped(text) + "' is not a whole number from " +
               std::to_string(low) + " to " + std::to_string(high));
}

std::optional<Error> read_seconds(const std::string& text, Milliseconds& out) {
  if (text.empty()) return std::nullopt;
  const auto value = number_of<double>(text);
  if (value && *value >= 0 && *value <= kClientTimeoutMax) {
    out = Milliseconds(std::llround(std::ceil(*value * 1000)));
    return std::nullopt;
  }
  return usage("--client-timeout '" + escaped(text) +
               "' is not a number of seconds from 0 (never) to 86400");
}

Result<TransmitterOptions> options_of(const Typed& typed) {
  TransmitterOptions options;
  for (const std::string& source : typed.sources) options.sources.emplace_back(source);
  if (!typed.bind.empty()) options.bind = typed.bind;
  std::int64_t port = options.port;
  std::int64_t keyframe = options.keyframe_ms;
  std::int64_t classic_min = options.classic_min;
  if (auto error = read_whole("--port", typed.port, 0, 65535, port)) return *error;
  if (auto error =
          read_whole("--keyframe", typed.keyframe, 1, protocol::kDurationMsMax, keyframe)) {
    return *error;
  }
  if (auto error = read_whole("--classic-min", typed.classic_min, 0, 100, classic_min)) {
    return *error;
  }
  std::int64_t max_clients = 0;
  if (auto error =
          read_whole("--max-clients", typed.max_clients, 0, kMaxClientsMost, max_clients)) {
    return *error;
  }
  if (auto error = read_seconds(typed.client_timeout, options.client_timeout)) return *error;
  options.port = static_cast<std::uint16_t>(port);
  options.keyframe_ms = static_cast<std::uint32_t>(keyframe);
  options.classic_min = static_cast<int>(classic_min);
  options.max_clients = static_cast<std::size_t>(max_clients);
  options.loop = typed.loop;
  options.live = typed.live;
  options.check = typed.check;
  options.stats = typed.stats;
  auto source = read_source_options(typed.source);
  if (!source) return source.error();
  options.source = std::move(*source);
  if (typed.verbose && typed.quiet) return usage("-v and -q exclude each other");
  if (typed.verbose) options.log_level = "debug";
  if (typed.quiet) options.log_level = "error";
  if (!typed.log_level.empty()) options.log_level = typed.log_level;
  return options;
}

}  // namespace

Result<CommandLine> read_command_line(std::vector<std::string> arguments) {
  CLI::App app;
  Typed typed;
  describe(app, typed);
  if (auto parsed = parse_command_line(app, std::move(arguments)); !parsed) return parsed.error();
  if (typed.help) return CommandLine{help_text(), {}};
  if (typed.version) return CommandLine{version_text(), {}};
  // An empty word is what `--stats "$UNSET"` leaves behind: silence would hide the slip.
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& word : option->results()) {
      if (word.empty()) return usage(option->get_name() + " is empty");
    }
  }
  auto options = options_of(typed);
  if (!options) return options.error();
  if (auto valid = validate(*options); !valid) return valid.error();
  return CommandLine{{}, std::move(*options)};
}

Result<void> validate(const TransmitterOptions& options) {
  if (options.sources.empty()) {
    return usage("no SOURCE: name at least one stream file, such as six_expressions.txt");
  }
  if (options.bind.empty()) return usage("--bind is empty");
  if (options.keyframe_ms < 1 || options.keyframe_ms > protocol::kDurationMsMax) {
    return usage("--keyframe is outside 1 to " + std::to_string(protocol::kDurationMsMax));
  }
  if (options.classic_min < 0 || options.classic_min > 100) {
    return usage("--classic-min is outside 0 to 100");
  }
  if (options.client_timeout.count() < 0) return usage("--client-timeout is negative");
  return {};
}

std::string help_text() {
  return R"(usage: au-transmitter [OPTIONS] SOURCE...   or   au-transmitter convert --help
Streams sets of FACS Action Units over TCP to face-player and its like.

  SOURCE                 files or recordings; classic clients get the first
  --bind ADDR            address to listen on (127.0.0.1: this host only)
  --port N               port, 0 for any free one (4650)
  --keyframe MS          time of a keyframe that names none (250)
  --loop                 start again at the end instead of ending
  --live                 one clock for all: who comes late joins now
  --classic-min PERCENT  classic clients get no AU weaker than this (20)
  --client-timeout S     close those that take or answer nothing so long (0: no)
  --max-clients N        at a time; more are refused (0: as many as come)
  --stats FILE.json      on exit, write packets, bytes, seconds of every client
  --check                check the sources, print what they hold, serve nothing
  --rate HZ, --fps N, --au-scale S, --face-id N, --min-confidence C
                         how recordings are read: see convert --help
  --log-level LEVEL      trace, debug, info, warning, error or off (info)
  -v, --verbose          log level debug           -q, --quiet   log level error
  -h, --help             this text                 --version     and licence

Prints "listening on ADDR:PORT" when ready, logs to stderr, ends with Ctrl-C.
Exit codes: 0 done, 1 failed, 2 usage, 3 bad data, 4 unreadable, 5 network.

examples:
  au-transmitter data/streams/six_expressions.txt
  au-transmitter --bind 0.0.0.0 --live --loop talk.txt
  au-transmitter --loop --stats sent.json talk.txt surprise.txt
  printf '1111111' | nc 127.0.0.1 4650     (a whole client, for six keyframes)
)";
}

std::string version_text() {
  return "au-transmitter " AUCAST_VERSION "\nprotocol " +
         std::to_string(protocol::kProtocolVersion) +
         " (and classic)\nMIT licence, without any warranty\n";
}

}  // namespace aucast::server
