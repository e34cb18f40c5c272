#include "server/settings/transmitter_options.h"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "common/command_line.h"
#include "common/files.h"
#include "common/sources/profile.h"
#include "common/text.h"
#include "server/settings/option_table.h"
#include "server/settings/settings.h"

namespace aucast::server {
namespace {

// === --help, in columns
constexpr std::size_t kLineMax = 80;
constexpr std::size_t kTextColumn = 25;  ///< where explanations begin
constexpr std::size_t kHalfLine = 39;    ///< where the second of two options does
constexpr std::size_t kFirstMax = 44;    ///< the first is no longer

constexpr const char* kUsualConfig = "/etc/aucast/au-transmitter.toml";

/// The command line's words by option, as they were typed. Numbers are read by ourselves, so that
/// every message has one form.
struct Typed {
  std::map<std::string, std::vector<std::string>, std::less<>> words;
  std::map<std::string, std::string> word;  ///< of options that take one; CLI11 wants to know
  std::map<std::string, bool, std::less<>> flags;
  bool help = false;
  bool version = false;
  bool verbose = false;
  bool quiet = false;

  [[nodiscard]] bool flag(std::string_view name) const {
    const auto found = flags.find(name);
    return found != flags.end() && found->second;
  }
};

/// The options of --help, line by line: two of a section that are short share a line.
class HelpLines {
 public:
  void add(const OptionRow& row) {
    if (!row.heading.empty()) {
      end_line();
      text_ += std::string(row.heading) + "\n";
    }
    if (before_ != nullptr && add_beside(row)) return;
    end_line();
    before_ = &row;
  }

  [[nodiscard]] std::string finish() {
    end_line();
    return std::move(text_);
  }

 private:
  static std::string option_of(const OptionRow& row) {
    std::string option = "  " + typed_name(row);
    if (!row.argument.empty()) option += " " + std::string(row.argument);
    return option;
  }

  /// False when both are too long for one line.
  bool add_beside(const OptionRow& row) {
    std::string line = option_of(*before_) + "  " + std::string(before_->text);
    if (line.size() > kFirstMax) return false;
    line.resize(std::max(line.size() + 1, kHalfLine), ' ');
    line += option_of(row) + "  " + std::string(row.text);
    if (line.size() > kLineMax) return false;
    text_ += line + "\n";
    before_ = nullptr;
    return true;
  }

  void end_line() {
    if (before_ == nullptr) return;
    std::string line = option_of(*before_);
    line.resize(std::max(line.size() + 1, kTextColumn), ' ');
    text_ += line + std::string(before_->text) + "\n";
    before_ = nullptr;
  }

  std::string text_;
  const OptionRow* before_ = nullptr;  ///< waits for another short one beside it
};

Error usage(std::string message) {
  return {ErrorKind::Usage, std::move(message) + " (try --help)"};
}

void describe(CLI::App& app, Typed& typed) {
  app.set_help_flag();  // ours is made for one screen
  app.add_flag("-h,--help", typed.help);
  app.add_flag("--version", typed.version);
  app.add_flag("-v,--verbose", typed.verbose);
  app.add_flag("-q,--quiet", typed.quiet);
  for (const OptionRow& row : option_table()) {
    const std::string name(row.name);
    if (row.kind == OptionRow::Kind::Flag) {
      app.add_flag(typed_name(row), typed.flags[name]);
      continue;
    }
    if (row.kind == OptionRow::Kind::Words) {
      app.add_option(typed_name(row), typed.words[name]);
    } else {
      app.add_option(typed_name(row), typed.word[name]);
    }
  }
}

/// The settings file that is asked for, or the usual one if it is there.
Result<void> add_config(Settings& settings, const Typed& typed, const Surroundings& surroundings) {
  std::filesystem::path config;
  const std::string variable = variable_name(*find_option("config"));
  for (const auto& [name, value] : surroundings.environment) {
    if (name == variable) config = value;
  }
  if (const auto& words = typed.words.at("config"); !words.empty()) {
    if (words.front().empty()) return usage("--config is empty");
    config = words.front();
  }
  if (config.empty()) {
    if (surroundings.config.empty() || ::access(surroundings.config.c_str(), F_OK) != 0) return {};
    config = surroundings.config;
  }
  const auto text = read_file(config);
  if (!text && config == surroundings.config) {
    return Error{text.error().kind, text.error().message + " (--config /dev/null does without)"};
  }
  if (!text) return text.error();
  return add_file(settings, *text, config.string());
}

void add_command_line(Settings& settings, const Typed& typed) {
  const auto set = [&settings](const std::string& name, std::vector<std::string> words) {
    settings[name] = {std::move(words), Setting::Layer::CommandLine, {}, {}};
  };
  if (typed.verbose) set("log-level", {"debug"});
  if (typed.quiet) set("log-level", {"error"});
  for (const OptionRow& row : option_table()) {
    const std::string name(row.name);
    if (row.read == nullptr) continue;
    if (typed.flag(name)) set(name, {"true"});
    const auto words = typed.words.find(name);
    if (words != typed.words.end() && !words->second.empty()) set(name, words->second);
  }
}

Result<Settings> settings_of(const Typed& typed, const Surroundings& surroundings) {
  Settings settings = default_settings();
  if (auto added = add_config(settings, typed, surroundings); !added) return added.error();
  if (auto added = add_environment(settings, surroundings.environment); !added) {
    return added.error();
  }
  add_command_line(settings, typed);
  return settings;
}

/// The settings, and as comments what a profile makes of them.
Result<CommandLine> printed_config(const Settings& settings, const TransmitterOptions& options) {
  std::string text = print_config(settings);
  const SignalOptions& signal = options.source.signal;
  if (!signal.profile.empty()) {
    const auto conditioning = conditioning_of(signal);
    if (!conditioning) return conditioning.error();
    text += "\n# What " + escaped(signal.profile.string(), 200) + " and these come to:\n";
    std::istringstream lines(sources::format_profile(conditioning->profile));
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty() && line.front() != '#') text += "#   " + line + "\n";
    }
  }
  return CommandLine{std::move(text), {}};
}

}  // namespace

Surroundings surroundings_of_process() {
  Surroundings surroundings;
  surroundings.config = kUsualConfig;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) continue;
    surroundings.environment.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return surroundings;
}

Result<CommandLine> read_command_line(std::vector<std::string> arguments,
                                      const Surroundings& surroundings) {
  CLI::App app;
  Typed typed;
  describe(app, typed);
  if (auto parsed = parse_command_line(app, std::move(arguments)); !parsed) return parsed.error();
  for (const auto& [name, word] : typed.word) {
    typed.words[name] = app.get_option(typed_name(*find_option(name)))->results();
  }
  if (typed.help) return CommandLine{help_text(), {}};
  if (typed.version) return CommandLine{version_text(), {}};
  if (typed.verbose && typed.quiet) return usage("-v and -q exclude each other");
  const auto settings = settings_of(typed, surroundings);
  if (!settings) return settings.error();
  auto options = options_of(*settings);
  if (!options) return options.error();
  options->check = typed.flag("check");
  options->estimate = typed.flag("estimate");
  if (typed.flag("print-config")) return printed_config(*settings, *options);
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
  if (options.credentials.tls.certificate.empty() != options.credentials.tls.key.empty()) {
    return usage("--tls-cert and --tls-key go together");
  }
  if (!options.credentials.tls.authorities.empty() && options.credentials.tls.certificate.empty()) {
    return usage("--tls-client-ca needs --tls-cert and --tls-key");
  }
  if (options.client_timeout.count() < 0) return usage("--client-timeout is negative");
  return {};
}

std::string help_text() {
  std::string text =
      R"(usage: au-transmitter [OPTIONS] SOURCE...   or   au-transmitter convert --help
Streams sets of FACS Action Units over TCP to face-player and its like.
)";
  HelpLines lines;
  for (const OptionRow& row : option_table()) lines.add(row);
  return text + lines.finish() +
         R"(  -v, --verbose   -q, --quiet   log level debug, error    -h, --help   --version

Settings: --config's, then AUCAST_TRANSMITTER_<OPTION>, then the command line.
Prints "listening on ADDR:PORT" when ready, logs to stderr, ends with Ctrl-C.
SIGHUP reads the sources again, SIGUSR1 logs how things are.
Exit codes: 0 done, 1 failed, 2 usage, 3 bad data, 4 unreadable, 5 network.

  au-transmitter --bind 0.0.0.0 --live --loop talk.txt
  FeatureExtraction -device 0 -of - | au-transmitter -
  printf '1111111' | nc 127.0.0.1 4650     (a whole client, for six keyframes)
)";
}

std::string version_number() {
  return AUCAST_VERSION;
}

std::string version_text() {
  return "au-transmitter " + version_number() + "\nprotocol " +
         std::to_string(protocol::kProtocolVersion) +
         " (and classic)\nMIT licence, without any warranty\n";
}

}  // namespace aucast::server
