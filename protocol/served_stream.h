#pragma once

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "protocol/encoded_stream.h"
#include "protocol/encoded_track.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"
#include "protocol/upstream_stream.h"

namespace aucast::protocol {

/// A stream under the name that a hello asks for: a recorded one, which each client gets from its
/// beginning or from where its hello says; a live one, of which each client gets what is sent now;
/// or another server's, which becomes one of these as soon as that server has said which.
struct ServedStream {
  /// Nothing: what is served under this name is not here yet.
  using Kind = std::variant<std::monostate, RecordedStream, std::shared_ptr<const LiveChannel>,
                            std::shared_ptr<const UpstreamStream>>;

  std::string name;
  Kind kind{};
  std::string title{};  ///< for people; empty: none

  ServedStream() = default;
  explicit ServedStream(std::string its_name) : name(std::move(its_name)) {}
  ServedStream(std::string its_name, RecordedStream recorded)
      : name(std::move(its_name)), kind(std::move(recorded)) {}
  ServedStream(std::string its_name, std::shared_ptr<const EncodedStream> recorded)
      : ServedStream(std::move(its_name), RecordedStream{std::move(recorded)}) {}
  ServedStream(std::string its_name, std::shared_ptr<const LiveChannel> live)
      : name(std::move(its_name)), kind(std::move(live)) {}
  ServedStream(std::string its_name, std::shared_ptr<const UpstreamStream> upstream)
      : name(std::move(its_name)), kind(std::move(upstream)) {}

  /// What clients can be sent now, here or from another server; null: it is not recorded, or not
  /// known yet.
  [[nodiscard]] const RecordedStream* recorded() const;
  /// The same of a live one.
  [[nodiscard]] const std::shared_ptr<const LiveChannel>& live() const;
  /// What is known of another server's; null: it is our own.
  [[nodiscard]] const UpstreamStream* upstream() const;

  /// Clients can be sent it now.
  [[nodiscard]] bool known() const { return recorded() != nullptr || live() != nullptr; }
  /// Nothing is served under this name.
  [[nodiscard]] bool absent() const { return std::holds_alternative<std::monostate>(kind); }
  /// What it is called; empty: nobody knows yet.
  [[nodiscard]] const std::string& known_name() const {
    return name.empty() && upstream() != nullptr ? upstream()->name : name;
  }
  /// What a list of streams says of it. `loops`: a recorded one starts again at its end, and so has
  /// no length.
  [[nodiscard]] ListedStream listed(bool loops) const;
  /// At the server that it comes from it starts again at its end.
  [[nodiscard]] bool loops_there() const { return upstream() != nullptr && upstream()->loop; }

  friend bool operator==(const ServedStream&, const ServedStream&) = default;
};

}  // namespace aucast::protocol
