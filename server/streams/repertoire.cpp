#include "server/streams/repertoire.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

#include "common/time.h"
#include "protocol/caption.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

constexpr std::size_t kHeldBackLeast = 512;
constexpr std::size_t kHeldBackMost = 65536;
constexpr std::size_t kHeldBackOfSources = 2048;  ///< for sources whose rate is not known

/// How many bytes of keyframes the busiest stream sends in `time`, rounded up.
std::size_t bytes_in(const Repertoire& repertoire, Milliseconds time) {
  std::size_t most = 0;
  for (const auto& [stream, voice] : repertoire) {
    const protocol::RecordedStream* const recorded = stream.recorded();
    if (recorded == nullptr) continue;
    const std::size_t bytes = recorded->encoded->negotiated.bytes();
    const auto all = static_cast<std::size_t>(
        std::max<Milliseconds::rep>(protocol::length_of(*recorded->encoded).count(), 1));
    most = std::max(most, (bytes * static_cast<std::size_t>(time.count()) + all - 1) / all);
  }
  return most;
}

}  // namespace

Repertoire make_repertoire(const std::vector<Source>& sources) {
  Repertoire repertoire;
  for (const Source& source : sources) {
    auto& [stream, voice] = repertoire.emplace_back();
    stream.name = source.name;
    if (protocol::is_title(source.title.text)) stream.title = source.title.text;
    if (!source.stream) continue;
    voice = source.voice;
    protocol::RecordedStream recorded{source.stream, nullptr, source.voiced};
    if (!source.captions.empty()) {
      protocol::SpokenTrack spoken;
      spoken.captions = source.captions;
      recorded.spoken = std::make_shared<const protocol::SpokenTrack>(std::move(spoken));
    }
    stream.kind = std::move(recorded);
  }
  return repertoire;
}

Result<void> check_live_loop(const Repertoire& repertoire) {
  for (const auto& [stream, voice] : repertoire) {
    const protocol::RecordedStream* const recorded = stream.recorded();
    if (recorded != nullptr && protocol::length_of(*recorded->encoded) == Milliseconds::zero()) {
      return Error{ErrorKind::BadData, "the stream '" + stream.name +
                                           "' takes no time at all, so it cannot start again and "
                                           "again live; give its keyframes a time, such as ;250"};
    }
  }
  return {};
}

int held_back_for(const Repertoire& repertoire, const VoiceOptions& voice) {
  constexpr Milliseconds kTime = protocol::kLiveWindowTime / 2;
  const bool any_voice =
      std::any_of(repertoire.begin(), repertoire.end(),
                  [](const OfferedStream& offered) { return offered.voice.has_value(); });
  // Kilobits a second are bits a millisecond.
  const std::size_t of_voice =
      any_voice ? voice_kbits(voice.encoder) * static_cast<std::size_t>(kTime.count()) / 8 : 0;
  const std::size_t bytes = bytes_in(repertoire, kTime) + of_voice;
  const bool unknown =
      std::any_of(repertoire.begin(), repertoire.end(),
                  [](const OfferedStream& offered) { return offered.stream.absent(); });
  const std::size_t least = unknown ? kHeldBackOfSources : kHeldBackLeast;
  return static_cast<int>(std::clamp(bytes, least, kHeldBackMost));
}

}  // namespace aucast::server
