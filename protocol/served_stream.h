#pragma once

#include <memory>
#include <string>
#include <variant>

#include "protocol/encoded_stream.h"
#include "protocol/encoded_track.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"
#include "protocol/upstream_stream.h"

namespace aucast::protocol {

/// A stream, with the name by which a hello asks for it. A recorded stream is sent to each client
/// from its beginning or from where the client's hello says; of a live one each client gets what is
/// sent now. Whether another server's stream is recorded or live is known once that server says so.
struct ServedStream {
  /// monostate: nothing is here under this name yet.
  using Kind = std::variant<std::monostate, RecordedStream, std::shared_ptr<const LiveChannel>,
                            std::shared_ptr<const UpstreamStream>>;

  std::string name;
  Kind kind{};
  std::string title{};  ///< to show to people; empty: none

  /// The recorded stream, our own or another server's; null: it is not recorded, or not known yet.
  [[nodiscard]] const RecordedStream* recorded() const;
  /// The live stream, our own or another server's; null: it is not live, or not known yet.
  [[nodiscard]] const std::shared_ptr<const LiveChannel>& live() const;
  /// The stream of another server; null: it is our own.
  [[nodiscard]] const UpstreamStream* upstream() const;

  /// Whether it can be sent to clients now.
  [[nodiscard]] bool known() const { return recorded() != nullptr || live() != nullptr; }
  /// Whether nothing is here under this name.
  [[nodiscard]] bool absent() const { return std::holds_alternative<std::monostate>(kind); }
  /// Its name; empty: not known yet.
  [[nodiscard]] const std::string& known_name() const {
    return name.empty() && upstream() != nullptr ? upstream()->name : name;
  }
  /// What a list of streams says of it. `loops`: if recorded, the stream starts again at its end,
  /// and so has no length.
  [[nodiscard]] ListedStream listed(bool loops) const;
  /// Whether the server that it comes from starts it again at its end.
  [[nodiscard]] bool loops_there() const { return upstream() != nullptr && upstream()->loop; }

  friend bool operator==(const ServedStream&, const ServedStream&) = default;
};

}  // namespace aucast::protocol
