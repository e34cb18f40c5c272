#pragma once

#include <optional>
#include <vector>

#include "common/result.h"
#include "protocol/served_stream.h"
#include "server/settings/voice_options.h"
#include "server/streams/load_sources.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// A stream that is to be served.
struct OfferedStream {
  protocol::ServedStream stream;  ///< absent() if it is live: only its name is known yet
  /// The sound file of its voice, not encoded yet; nullopt: none.
  std::optional<VoiceFile> voice{};
};
using Repertoire = std::vector<OfferedStream>;

/// The streams of the sources, in the order given.
[[nodiscard]] Repertoire make_repertoire(const std::vector<Source>& sources);

/// Fails with BadData unless the streams can be sent live in a loop: each must take some time.
[[nodiscard]] Result<void> check_live_loop(const Repertoire& repertoire);

/// The `held_back_max` for link::tcp_link(), for clients of these streams when they are live: as
/// much as the busiest stream sends in kLiveWindowTime / 2, within bounds, so that no packet has to
/// wait until the previous one is sent.
[[nodiscard]] int held_back_for(const Repertoire& repertoire, const VoiceOptions& voice);

}  // namespace aucast::server
