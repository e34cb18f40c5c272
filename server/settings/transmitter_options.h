#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "protocol/limits.h"
#include "server/settings/credential_files.h"
#include "server/settings/engine_settings.h"
#include "server/settings/push_settings.h"
#include "server/settings/source_options.h"
#include "server/settings/upstream_settings.h"
#include "server/settings/voice_options.h"

namespace aucast::server {

/// Where --http or --web answers.
struct HttpAddress {
  std::string address;     ///< of this host; brackets allowed
  std::uint16_t port = 0;  ///< 0: any free one
  friend bool operator==(const HttpAddress&, const HttpAddress&) = default;
};

/// The page and the WebSocket for browsers.
struct WebOptions {
  std::optional<HttpAddress> address;        ///< nothing: there is none
  std::vector<std::string> hosts;            ///< names that it answers for, of pages that may watch
  std::vector<std::string> trusted_proxies;  ///< addresses whose X-Forwarded-For is believed
  friend bool operator==(const WebOptions&, const WebOptions&) = default;
};

/// Everything that au-transmitter's command line says.
struct TransmitterOptions {
  std::vector<std::filesystem::path> sources;   ///< may be none where publishers bring streams
  std::string bind = "127.0.0.1";               ///< address or name of this host
  std::uint16_t port = protocol::kDefaultPort;  ///< 0: any free one
  Milliseconds drain_time{0};                   ///< to send clients away in; 0: they get {-2}
  bool reuse_port = false;                      ///< other processes may listen there too
  std::uint32_t keyframe_ms = 250;              ///< 1 to kDurationMsMax; for untimed keyframes
  bool loop = false;                            ///< start again at the end instead of {-2}
  bool live = false;                            ///< one clock for all clients
  int classic_min = 20;                         ///< percent 0-100; classic clients get no less
  Milliseconds client_timeout{0};               ///< longest wait for an answer; 0: for ever
  std::size_t max_clients = 0;                  ///< at a time; 0: clients_with_room()
  std::size_t max_clients_per_address = 0;      ///< the same from one address
  CredentialFiles credentials;                  ///< certificates and token
  std::uint32_t max_kbits = 0;                  ///< a second and client; 0: no limit
  Milliseconds batch{0};                        ///< how long small writes wait for each other
  bool estimate = false;                        ///< say what the sources need and serve nothing
  std::filesystem::path stats;                  ///< empty: none
  bool check = false;                           ///< check the sources and serve nothing
  SourceOptions source;                         ///< how recordings are read
  VoiceOptions voice;                           ///< the sound beside the faces
  bool skip_bad = false;                        ///< broken sources are left out
  bool preview = false;                         ///< stdout tells what the camera sees
  std::optional<HttpAddress> http;              ///< nothing: no status by HTTP
  WebOptions web;                               ///< the page for browsers
  std::filesystem::path record;                 ///< file or folder for live streams; empty: none
  LiveSourceSettings live_source;               ///< how those are served that are being written
  UpstreamSettings upstream;                    ///< streams of other servers
  EngineSettings engine;                        ///< streams over NATS
  PushSettings push;                            ///< streams that are brought to other servers
  std::string log_level = "info";               ///< as common/log.h takes it
  std::string log_format = "text";              ///< or "json"
  friend bool operator==(const TransmitterOptions&, const TransmitterOptions&) = default;
};

/// A command line that was understood: a text to print and be done with (--help, --version,
/// --print-config), or options to work by.
struct CommandLine {
  std::string text;  ///< empty: go on with `options`
  TransmitterOptions options;
};

/// Where settings come from beside the command line. As it stands here: from nowhere.
struct Surroundings {
  std::vector<std::pair<std::string, std::string>> environment;  ///< names and values
  std::filesystem::path config;  ///< the settings file that is read if it is there
};

/// Of this process: its environment, and /etc/aucast/au-transmitter.toml.
[[nodiscard]] Surroundings surroundings_of_process();

/// Reads the arguments (without the program's name) on top of environment and settings file.
/// Usage error, one line, with the nearest known option for one that is not known; BadData or
/// Unreadable for the settings file.
[[nodiscard]] Result<CommandLine> read_command_line(std::vector<std::string> arguments,
                                                    const Surroundings& surroundings = {});

/// Checks what the options say together and each range; read_command_line() has done so already.
[[nodiscard]] Result<void> validate(const TransmitterOptions& options);

/// "0.1.0"
[[nodiscard]] std::string version_number();

/// What --version prints: version, protocol, licence.
[[nodiscard]] std::string version_text();

}  // namespace aucast::server
