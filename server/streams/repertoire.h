#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/result.h"
#include "protocol/server_session.h"
#include "server/settings/voice_options.h"
#include "server/streams/load_sources.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// What is served, and the sound files whose voices are to go with it.
struct Repertoire {
  // Implicit on purpose: streams without a voice are a repertoire too.
  Repertoire(protocol::ServerCatalogue streams) : catalogue(std::move(streams)) {}

  protocol::ServerCatalogue catalogue;
  std::vector<std::optional<VoiceFile>> voices;  ///< of each stream; missing ones: none
};

/// The streams of the sources, in the order given; of one that is live only the name is known yet.
/// The voices are still to be encoded.
[[nodiscard]] Repertoire make_repertoire(const std::vector<Source>& sources,
                                         std::uint32_t keyframe_ms, bool loop);

/// Whether the streams can be sent live: one that starts again must take some time. Bad data
/// otherwise.
[[nodiscard]] Result<void> check_live(const protocol::ServerCatalogue& catalogue);

/// What the system may hold back unsent for a client of one of these streams, when they are live:
/// some time's worth of the busiest one, but not so little that every packet has to wait for the
/// previous one.
[[nodiscard]] int held_back_for(const protocol::ServerCatalogue& catalogue,
                                const VoiceOptions& voice);

}  // namespace aucast::server
