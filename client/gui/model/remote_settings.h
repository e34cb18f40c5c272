#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/playback/keyframe_buffers.h"
#include "client/playback/source_playback.h"
#include "protocol/endpoint.h"
#include "protocol/limits.h"
#include "protocol/packet.h"

namespace aucast::gui {

/// How far behind the server the face is.
enum class Behind : std::uint8_t {
  Sets,  ///< by the number of sets in the buffers, as the form says
  Live,  ///< by as little as the link allows
  Auto,  ///< by as much as the link needs
  Time,  ///< by `behind_ms`
};

/// The contents of the remote player's form.
struct RemoteSettings {
  static constexpr int kPortMax = 65535;
  static constexpr int kSetsMax = playback::BufferOptions::kSetsMax;
  static constexpr int kSpeedMsMax = playback::SourcePlayback::kSpeedMax.count();
  static constexpr int kBehindMsMax = playback::BufferOptions::kDelayMax.count();

  std::string address = "127.0.0.1";  ///< a host
  int port = protocol::kDefaultPort;
  int buffer = 100;  ///< sets, 1 to kSetsMax
  int playout = 30;  ///< sets, 1 to `buffer`
  int threshold_percent = 40;
  int speed_ms = 0;        ///< 1 to kSpeedMsMax; 0: the server's own time
  bool reconnect = false;  ///< try again when the server is lost
  std::string stream{};    ///< empty: the server's first
  bool tls = false;
  std::string authorities_file{};            ///< of TLS; empty: as the command line says
  std::string token_file{};                  ///< of the token; empty: as the command line says
  std::vector<protocol::Endpoint> others{};  ///< other servers of the stream, tried in turn
  Behind behind = Behind::Sets;
  int behind_ms = 300;  ///< 0 to kBehindMsMax, of Behind::Time
  friend bool operator==(const RemoteSettings&, const RemoteSettings&) = default;
};

/// The streams of the server in the form.
struct StreamsView {
  bool asking = false;
  std::vector<protocol::ListedStream> streams;
  std::string problem;  ///< why there are no streams, as a sentence
  friend bool operator==(const StreamsView&, const StreamsView&) = default;
};

/// What is wrong with the form, as a sentence with the remedy; nullopt: nothing. The limits are
/// those of the command line.
[[nodiscard]] std::optional<std::string> problem(const RemoteSettings& settings);

/// The address: HOST, or HOST:PORT if the port is not the default one. If a stream or other hosts
/// are named, it is aucast://HOST[:PORT][,HOST[:PORT]...][/STREAM]. For TLS it begins with
/// aucasts://.
[[nodiscard]] std::string address_text(const RemoteSettings& settings);
/// The same without the stream, which has a field of its own.
[[nodiscard]] std::string server_text(const RemoteSettings& settings);
/// `settings`, but with the server of `other`, that is, with its addresses, protection and stream.
[[nodiscard]] RemoteSettings with_server_of(RemoteSettings settings, const RemoteSettings& other);
/// Reads `text`, as address_text() writes it or as HOST[:PORT]/STREAM, into address, port, others,
/// stream and tls of `settings`. If `text` is wrong, changes nothing and returns a sentence that
/// says why; else returns nullopt.
[[nodiscard]] std::optional<std::string> take_address(std::string_view text,
                                                      RemoteSettings& settings);

}  // namespace aucast::gui
