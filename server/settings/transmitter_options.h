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
#include "server/settings/other_servers.h"
#include "server/settings/source_options.h"
#include "server/settings/voice_options.h"

namespace aucast::server {

/// Where --http or --web listens.
struct HttpAddress {
  std::string address;     ///< address or name of this host; brackets allowed
  std::uint16_t port = 0;  ///< 0: any free one
  friend bool operator==(const HttpAddress&, const HttpAddress&) = default;
};

/// The page and the WebSocket for browsers.
struct WebOptions {
  std::optional<HttpAddress> address;  ///< nullopt: there is no page
  std::vector<std::string> hosts;      ///< names of this server; pages from these names may watch
  std::vector<std::string> trusted_proxies;  ///< addresses whose X-Forwarded-For is believed
  friend bool operator==(const WebOptions&, const WebOptions&) = default;
};

/// All options of au-transmitter.
struct TransmitterOptions {
  std::vector<std::filesystem::path> sources;   ///< may be empty if publishers send streams
  std::string bind = "127.0.0.1";               ///< address or name of this host
  std::uint16_t port = protocol::kDefaultPort;  ///< 0: any free one
  Milliseconds drain_time{0};  ///< in which clients are sent away; 0: they get {-2}
  bool reuse_port = false;     ///< other processes may listen at the same port
  std::uint32_t keyframe_ms =
      protocol::kDefaultKeyframeTime.count();  ///< 1 to kKeyframeTimeMsMax; for untimed keyframes
  bool loop = false;                           ///< start again at the end instead of {-2}
  bool live = false;                           ///< one clock for all clients
  int classic_min = 20;            ///< percent 0-100; weaker AUs are left out for classic clients
  Milliseconds client_timeout{0};  ///< longest wait for an answer that is owed; 0: no limit
  std::size_t max_clients = 0;     ///< at a time; 0: clients_with_room()
  std::size_t max_clients_per_address = 0;  ///< the same from one address; 0: no limit
  CredentialFiles credentials;              ///< certificates and tokens
  std::uint32_t max_kbits = 0;              ///< kilobits a second for each client; 0: no limit
  Milliseconds batch{0};                    ///< how long small writes wait for more; 0: not at all
  bool estimate = false;                    ///< print what the sources need, and serve nothing
  std::filesystem::path stats;              ///< empty: none
  bool check = false;                       ///< check the sources, and serve nothing
  SourceOptions source;                     ///< how recordings are read
  VoiceOptions voice;                       ///< the sound beside the faces
  bool skip_bad = false;                    ///< broken sources are left out
  bool preview = false;                     ///< write what the camera sees to stdout
  std::optional<HttpAddress> http;          ///< nullopt: no status by HTTP
  WebOptions web;                           ///< the page for browsers
  std::filesystem::path record;             ///< file or folder for live streams; empty: none
  LiveSourceSettings live_source;           ///< how sources that are still being written are served
  UpstreamSettings upstream;                ///< streams of other servers
  EngineSettings engine;                    ///< streams over NATS
  PushSettings push;                        ///< streams that are sent to other servers
  std::string log_level = "info";           ///< as common/log.h takes it
  std::string log_format = "text";          ///< or "json"
  friend bool operator==(const TransmitterOptions&, const TransmitterOptions&) = default;
};

/// A command line that was understood: options, or a text to print before exiting (--help,
/// --version, --print-config).
struct CommandLine {
  std::string text;  ///< empty: go on with `options`
  TransmitterOptions options;
};

/// Where settings come from besides the command line; by default, nowhere.
struct Surroundings {
  std::vector<std::pair<std::string, std::string>> environment;  ///< names and values
  std::filesystem::path config;  ///< the settings file, read if it exists
};

/// Those of this process: its environment, and /etc/aucast/au-transmitter.toml.
[[nodiscard]] Surroundings surroundings_of_process();

/// Reads the arguments (without the program's name) on top of environment and settings file.
/// Fails with a Usage error of one line, which names the nearest known option for an unknown one;
/// with BadData or Unreadable for the settings file.
[[nodiscard]] Result<CommandLine> read_command_line(std::vector<std::string> arguments,
                                                    const Surroundings& surroundings = {});

/// Checks what depends on more than one option; ranges are checked when words are read.
/// read_command_line() does so itself.
[[nodiscard]] Result<void> validate(const TransmitterOptions& options);

/// "0.2.0"
[[nodiscard]] std::string version_number();

/// What --version prints: version, protocol, licence.
[[nodiscard]] std::string version_text();

}  // namespace aucast::server
