#include "protocol/served_stream.h"

namespace aucast::protocol {
namespace {

using Live = std::shared_ptr<const LiveChannel>;

template <typename Kind>
const Live& live_of(const Kind& kind) {
  static const Live none;
  const Live* const live = std::get_if<Live>(&kind);
  return live != nullptr ? *live : none;
}

}  // namespace

const Live& UpstreamStream::live() const {
  return live_of(content);
}

const RecordedStream* ServedStream::recorded() const {
  const UpstreamStream* const from = upstream();
  return from != nullptr ? from->recorded() : std::get_if<RecordedStream>(&kind);
}

const Live& ServedStream::live() const {
  const UpstreamStream* const from = upstream();
  return from != nullptr ? from->live() : live_of(kind);
}

const UpstreamStream* ServedStream::upstream() const {
  const auto* const from = std::get_if<std::shared_ptr<const UpstreamStream>>(&kind);
  return from != nullptr ? from->get() : nullptr;
}

ListedStream ServedStream::listed(bool loops) const {
  ListedStream listed{.name = known_name(),
                      .title = upstream() != nullptr ? upstream()->title : title};
  if (known()) listed.live = live() != nullptr;
  if (live()) {
    listed.duration_ms = live()->duration_ms();
  } else if (const RecordedStream* const of = recorded(); of && !loops && !loops_there()) {
    listed.duration_ms = of->for_listeners()->duration_ms;
  }
  return listed;
}

}  // namespace aucast::protocol
