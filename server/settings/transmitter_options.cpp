#include "server/settings/transmitter_options.h"

#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/sources/profile.h"
#include "common/text.h"
#include "protocol/endpoint.h"
#include "server/settings/option_table.h"
#include "server/settings/settings.h"

namespace aucast::server {
namespace {

constexpr const char* kUsualConfig = "/etc/aucast/au-transmitter.toml";
constexpr std::string_view kConfigVariable = "AUCAST_TRANSMITTER_CONFIG";

/// The settings file that was asked for, or the usual one if it exists.
Result<void> add_config(Settings& settings, const TypedWords& typed,
                        const Surroundings& surroundings) {
  std::filesystem::path config;
  for (const auto& [name, value] : surroundings.environment) {
    if (name == kConfigVariable) config = value;
  }
  if (const auto found = typed.find("config"); found != typed.end()) {
    if (found->second.front().empty()) return usage_error("--config is empty");
    config = found->second.front();
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
  return settings.add_file(*text, config.string());
}

/// The settings, with what the profile makes of them as comments.
Result<CommandLine> printed_config(const Settings& settings, const TransmitterOptions& options) {
  std::string text = settings.print();
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

/// Checks the options about what is served and what is sent to others.
Result<void> validate_streams(const TransmitterOptions& options) {
  const bool any = !options.sources.empty();
  if (!any && options.credentials.publishers.empty()) {
    return usage_error("no SOURCE: name at least one stream file, such as six_expressions.txt");
  }
  if (!any && !options.push.addresses.empty())
    return usage_error("--push brings a SOURCE; name one");
  if (!any && !options.voice.file.empty()) return usage_error("--voice is for a SOURCE; name one");
  if (!options.record.empty() && !options.voice.file.empty() &&
      options.record.extension() == ".opus") {
    return usage_error("--record keeps the face in FILE and the voice beside it as .opus: give " +
                       printable(options.record.string()) + " another ending, such as .txt");
  }
  if (options.voice.none && !options.voice.file.empty()) {
    return usage_error("--no-voice leaves nothing for --voice to name: give one of them");
  }
  std::vector<protocol::StreamAddress> pushed;
  for (const std::string& address : options.push.addresses) {
    auto parsed = protocol::parse_stream_address(address);
    if (!parsed) return parsed.error();
    if (std::find(pushed.begin(), pushed.end(), *parsed) != pushed.end()) {
      return usage_error("--push " + escaped(address) + " is there twice: leave one out");
    }
    pushed.push_back(*std::move(parsed));
  }
  return {};
}

/// Checks that there is somebody to show tokens and certificates to: their files are read only
/// then, and one that is missing would not be noticed.
Result<void> validate_secrets(const TransmitterOptions& options) {
  const auto any_source = [&options](bool (*is_one)(std::string_view)) {
    return std::any_of(options.sources.begin(), options.sources.end(),
                       [is_one](const auto& source) { return is_one(source.string()); });
  };
  const PushSettings& push = options.push;
  if (push.addresses.empty() && !(push.token.empty() && push.tls == tls::Files{})) {
    return usage_error("--push-token-file and --push-tls-ca need --push");
  }
  const UpstreamSettings& upstream = options.upstream;
  if (!any_source(protocol::is_stream_address) &&
      !(upstream.token.empty() && upstream.tls == tls::Files{})) {
    return usage_error("--upstream-token-file and --upstream-tls-ca need a SOURCE aucast://HOST");
  }
  const EngineSettings& engine = options.engine;
  const bool nats = !engine.publish.empty() || any_source(protocol::is_engine_address);
  if (!nats && engine != EngineSettings{}) {
    return usage_error("--nats-... options need --publish or a SOURCE nats://HOST/NAME");
  }
  return {};
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
  TransmitterOptions options;
  const std::vector<OptionRow> rows = option_rows(options);
  auto typed = sort_arguments(rows, std::move(arguments));
  if (!typed) return typed.error();
  if (typed->contains("help")) return CommandLine{help_text(transmitter_page()), {}};
  if (typed->contains("version")) return CommandLine{version_text(), {}};
  if (auto level = apply_verbosity(*typed, {"debug"}); !level) return level.error();
  Settings settings(rows);
  if (auto added = add_config(settings, *typed, surroundings); !added) return added.error();
  if (auto added = settings.add_environment(surroundings.environment); !added) return added.error();
  settings.add_typed(*typed);
  if (auto read = settings.read(); !read) return read.error();
  if (typed->contains("print-config")) return printed_config(settings, options);
  if (auto valid = validate(options); !valid) return valid.error();
  // What is published is everybody's one moment.
  if (!options.engine.publish.empty()) options.live = true;
  return CommandLine{{}, std::move(options)};
}

Result<void> validate(const TransmitterOptions& options) {
  if (auto can = validate_streams(options); !can) return can;
  if (auto can = validate_secrets(options); !can) return can;
  if (options.bind.empty()) return usage_error("--bind is empty");
  if (options.credentials.tls.certificate.empty() != options.credentials.tls.key.empty()) {
    return usage_error("--tls-cert and --tls-key go together");
  }
  if (!options.credentials.tls.authorities.empty() && options.credentials.tls.certificate.empty()) {
    return usage_error("--tls-client-ca needs --tls-cert and --tls-key");
  }
  if (options.credentials.web.certificate.empty() != options.credentials.web.key.empty()) {
    return usage_error("--web-cert and --web-key go together");
  }
  const bool any_web = !options.credentials.web.certificate.empty() || !options.web.hosts.empty() ||
                       !options.web.trusted_proxies.empty();
  if (any_web && !options.web.address) {
    return usage_error("--web-cert, --web-host and --web-trusted-proxy need --web");
  }
  if (!options.engine.publish.empty()) {
    const auto address = protocol::parse_engine_address(options.engine.publish);
    if (!address) return address.error();
  }
  return {};
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
