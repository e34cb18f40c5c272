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

/// The streams that are served, and the sound files for their voices.
struct Repertoire {
  // Implicit on purpose: streams without a voice are a repertoire too.
  Repertoire(protocol::ServerCatalogue streams) : catalogue(std::move(streams)) {}

  protocol::ServerCatalogue catalogue;
  std::vector<std::optional<VoiceFile>> voices;  ///< by stream; streams beyond its end have none
};

/// The streams of the sources, in the order given; a live one has only a name yet. The voices are
/// not encoded yet.
[[nodiscard]] Repertoire make_repertoire(const std::vector<Source>& sources,
                                         std::uint32_t keyframe_ms, bool loop);

/// Fails with BadData unless the streams can be sent live: a looped one must take some time.
[[nodiscard]] Result<void> check_live(const protocol::ServerCatalogue& catalogue);

/// The `held_back_max` for link::tcp_link(), for clients of these streams when they are live: as
/// much as the busiest stream sends in kLiveWindowTime / 2, within bounds, so that no packet has to
/// wait until the previous one is sent.
[[nodiscard]] int held_back_for(const protocol::ServerCatalogue& catalogue,
                                const VoiceOptions& voice);

}  // namespace aucast::server
