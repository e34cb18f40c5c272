#include "protocol/stream_choice.h"

#include <algorithm>
#include <string>

#include "protocol/limits.h"
#include "protocol/server_chain.h"

namespace aucast::protocol {
namespace {

/// The chain of servers through which a client gets the stream; this one is the last.
std::string servers_of(const ServerCatalogue& catalogue, const ServedStream& stream) {
  return chained(stream.upstream() != nullptr ? stream.upstream()->servers : std::string(),
                 catalogue.id);
}

bool tells_servers(const ServerCatalogue& catalogue, const HelloAsked& asked) {
  return !asked.relay.empty() && !catalogue.id.empty();
}

/// False for a growing stream that does not have the client's first keyframe yet.
bool is_here(const EncodedStream& stream, std::uint64_t from_ms, bool loops) {
  return stream.extent != Extent::Growing ||
         entry_at(stream, from_ms, loops).keyframe < stream.times.size();
}

}  // namespace

StreamChoice choose_stream(const ServerCatalogue& catalogue,
                           const std::optional<HelloAsked>& asked) {
  using State = StreamChoice::State;
  const auto& streams = catalogue.streams;
  auto found = streams.begin();
  if (asked && !asked->stream.empty()) {
    found = std::find_if(streams.begin(), streams.end(), [&asked](const ServedStream& candidate) {
      return candidate.known_name() == asked->stream;
    });
  }
  StreamChoice choice;
  if (found == streams.end()) {
    const bool may_come = catalogue.patience ||
                          std::any_of(streams.begin(), streams.end(), [](const auto& candidate) {
                            return candidate.known_name().empty();
                          });
    choice.state = may_come ? State::NotYet : State::Refused;
    if (asked) choice.refusal = {kNoSuchStream, "there is no stream '" + asked->stream + "' here"};
    choice.patience = catalogue.patience.value_or(choice.patience);
    return choice;
  }
  choice.stream = *found;
  ServedStream& stream = choice.stream;
  if (const UpstreamStream* const upstream = stream.upstream()) {
    if (stream.name.empty()) stream.name = upstream->name;
    stream.title = upstream->title;
    choice.patience = upstream->patience;
  }
  if (asked) {
    if (auto refusal = relay_refused(catalogue, stream, *asked)) {
      choice.state = State::Refused;
      choice.refusal = *std::move(refusal);
      return choice;
    }
  }
  const bool loops = (catalogue.loop || stream.loops_there()) && !(asked && asked->loop);
  const RecordedStream* const recorded = stream.recorded();
  const bool ready =
      stream.live() ||
      (recorded != nullptr && is_here(*recorded->encoded, asked ? asked->from_ms : 0, loops));
  if (!ready) choice.state = State::NotYet;
  return choice;
}

std::optional<ErrorReply> relay_refused(const ServerCatalogue& catalogue,
                                        const ServedStream& stream, const HelloAsked& asked) {
  if (!tells_servers(catalogue, asked)) return std::nullopt;
  const std::string servers = servers_of(catalogue, stream);
  if (passes_through(servers, asked.relay)) {
    return ErrorReply{kRoundAbout, "the stream would come back to the relay that asks for it"};
  }
  if (servers_in(servers) > kRelayHopsMax) {
    return ErrorReply{kRoundAbout, "the stream has come through " + std::to_string(kRelayHopsMax) +
                                       " relays already, which is the most"};
  }
  return std::nullopt;
}

std::string servers_told(const ServerCatalogue& catalogue, const ServedStream& stream,
                         const HelloAsked& asked) {
  return tells_servers(catalogue, asked) ? servers_of(catalogue, stream) : std::string();
}

}  // namespace aucast::protocol
