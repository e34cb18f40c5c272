#include "server/serve/programme.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <asio/post.hpp>

#include "common/log.h"
#include "common/random_digits.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

/// 128 bits, which nobody guesses.
constexpr std::size_t kOwnerTokenDigits = 32;

}  // namespace

Programme::Programme(asio::io_context& io, const TransmitterOptions& options, Repertoire repertoire,
                     Events events)
    : io_(io),
      options_(options),
      events_(std::move(events)),
      id_(random_digits(kIdDigits)),
      sources_(io, options, id_, [this](const std::string& name) { return take_name(name); },
               {[this] { on_moment_of_source(); }, [this] { add_faces(); }, events_.on_sight}),
      pushed_(io, {id_, options.upstream.wait, options.classic_min},
              {events_.on_moment, [this] { serve_pushed(*catalogue_); }}),
      beat_(io, events_.on_moment,
            {link_limits(options), options.keyframe_ms, options.classic_min}),
      voices_(io, options.voice.encoder, [this] { events_.on_voice(); }),
      catalogue_(std::make_shared<protocol::ServerCatalogue>(accompanied(std::move(repertoire)))),
      held_back_max_(held_back_for(*catalogue_, options.voice)) {
  catalogue_->id = id_;
  catalogue_->owner_token = random_digits(kOwnerTokenDigits);
  open_to_publishers();
}

/// Lets publishers add streams to the catalogue, for which clients may wait.
void Programme::open_to_publishers() {
  if (!takes_streams()) return;
  catalogue_->patience = std::min<Milliseconds>(options_.upstream.wait, protocol::kStreamWaitMax);
  catalogue_->publish_refused = [this](const protocol::HelloAsked& hello) {
    return publish_refused(hello);
  };
}

void Programme::set_tokens(std::string token,
                           std::shared_ptr<const protocol::Publishers> publishers) {
  catalogue_->token = std::move(token);
  catalogue_->publishers = std::move(publishers);
}

bool Programme::is_own(const std::string& name) const {
  const auto& streams = catalogue_->streams;
  const auto named = [&name](const auto& stream) { return stream.known_name() == name; };
  const auto& pushed = pushed_names_;
  return std::find(pushed.begin(), pushed.end(), name) == pushed.end() &&
         std::any_of(streams.begin(), streams.end(), named);
}

/// Takes a name for another stream of a running source, if need be from a publisher; false if
/// another stream of our own has it.
bool Programme::take_name(const std::string& name) {
  if (is_own(name)) return false;
  pushed_.give_way(name);
  serve_pushed(*catalogue_);
  return true;
}

std::optional<protocol::ErrorReply> Programme::publish_refused(
    const protocol::HelloAsked& hello) const {
  if (is_own(hello.publish)) {
    return protocol::ErrorReply{
        409, "the stream '" + hello.publish + "' is one of this server's own; use another name"};
  }
  if (auto refusal = pushed_.refusal(hello)) return refusal;
  if (stopped_) return protocol::ErrorReply{503, "the server stops"};
  return std::nullopt;
}

/// Replaces the pushed streams in the catalogue by the present ones, after our own.
void Programme::serve_pushed(protocol::ServerCatalogue& catalogue) {
  std::erase_if(catalogue.streams, [this](const protocol::ServedStream& stream) {
    return std::find(pushed_names_.begin(), pushed_names_.end(), stream.name) !=
           pushed_names_.end();
  });
  pushed_names_.clear();
  for (protocol::ServedStream& stream : pushed_.streams()) {
    pushed_names_.push_back(stream.name);
    catalogue.streams.push_back(std::move(stream));
  }
}

const protocol::ServedStream* Programme::named(const std::string& name) const {
  const auto& streams = catalogue_->streams;
  if (streams.empty()) return nullptr;
  const auto found = std::find_if(streams.begin(), streams.end(), [&name](const auto& stream) {
    return stream.known_name() == name;
  });
  return found == streams.end() ? &streams.front() : &*found;
}

std::shared_ptr<const protocol::ServerCatalogue> Programme::alone(const std::string& name) const {
  auto one = std::make_shared<protocol::ServerCatalogue>();
  const protocol::ServedStream* const stream = named(name);
  one->streams.push_back(stream == nullptr ? protocol::ServedStream() : *stream);
  if (!name.empty()) one->streams.front().name = name;
  one->keyframe_ms = catalogue_->keyframe_ms;
  one->loop = catalogue_->loop;
  one->id = catalogue_->id;
  return one;
}

void Programme::on_moment_of_source() {
  events_.on_moment();
  // Not now: it is a source that calls.
  if (over()) asio::post(io_, events_.on_over);
}

/// Adds the streams of new faces.
void Programme::add_faces() {
  if (!stopped_) make_live(*catalogue_);
}

/// Leaves out what was read under names that streams of running sources have got since the start.
void Programme::leave_out_taken(protocol::ServerCatalogue& catalogue) const {
  const auto of_sources = sources_.streams();
  std::erase_if(catalogue.streams, [&of_sources](const protocol::ServedStream& stream) {
    const bool taken = !stream.absent() && std::any_of(of_sources.begin(), of_sources.end(),
                                                       [&stream](const auto& other) {
                                                         return other.known_name() == stream.name;
                                                       });
    if (taken) spdlog::error("{}: another source has that name now; rename the file", stream.name);
    return taken;
  });
}

/// Gives each stream that is to be live its channel: that of its source or, for a recording with
/// --live, one that plays it. Adds streams for a source's faces.
void Programme::make_live(protocol::ServerCatalogue& catalogue) {
  for (protocol::ServedStream& stream : catalogue.streams) {
    const auto* const recorded = std::get_if<protocol::RecordedStream>(&stream.kind);
    if (recorded == nullptr || !options_.live) continue;
    stream.kind =
        beat_.play(stream.name, recorded->for_listeners(), options_.loop, recorded->spoken);
  }
  for (protocol::ServedStream& of_source : sources_.streams()) {
    const auto same =
        std::find_if(catalogue.streams.begin(), catalogue.streams.end(),
                     [&of_source](const auto& stream) { return stream.name == of_source.name; });
    if (same == catalogue.streams.end()) {
      catalogue.streams.push_back(std::move(of_source));
    } else if (same->absent()) {
      same->kind = std::move(of_source.kind);
    }
  }
  std::erase_if(catalogue.streams, [](const protocol::ServedStream& stream) {
    if (stream.absent()) {
      spdlog::error("{}: it is written live now and was not at the start; restart to serve it",
                    stream.name);
    }
    return stream.absent();
  });
}

/// Whether a client that comes now may be sent a live stream, if only later.
bool Programme::may_be_live() const {
  const auto& streams = catalogue_->streams;
  return options_.live || takes_streams() ||
         std::any_of(streams.begin(), streams.end(),
                     [](const auto& stream) { return stream.live() || !stream.known(); });
}

/// Called at every keyframe: returns early while a source goes on, before it makes a list of
/// streams.
bool Programme::over() const {
  if (takes_streams() || !sources_.over()) return false;
  const auto of_sources = sources_.streams();
  const auto& served = catalogue_->streams;
  return std::all_of(served.begin(), served.end(), [&of_sources](const auto& stream) {
    return std::any_of(of_sources.begin(), of_sources.end(),
                       [&stream](const auto& other) { return other.kind == stream.kind; });
  });
}

void Programme::stop() {
  stopped_ = true;
  voices_.stop();
  sources_.stop();
  pushed_.stop();
  beat_.stop();
}

bool Programme::take_over(Repertoire repertoire) {
  protocol::ServerCatalogue loaded = accompanied(std::move(repertoire));
  const int held_back_max = held_back_for(loaded, options_.voice);
  leave_out_taken(loaded);
  make_live(loaded);
  if (loaded.streams.empty() && !takes_streams()) return false;
  for (const protocol::ServedStream& own : loaded.streams) pushed_.give_way(own.known_name());
  pushed_names_.clear();
  serve_pushed(loaded);
  share_with_before(loaded);
  if (loaded.streams == catalogue_->streams) {
    spdlog::info("the sources hold what they held");
    return false;
  }
  catalogue_->streams = std::move(loaded.streams);
  held_back_max_ = held_back_max;
  // Who waits for a stream may find it among these.
  events_.on_moment();
  return true;
}

/// Adds the voices to the streams; they grow from now on.
protocol::ServerCatalogue Programme::accompanied(Repertoire repertoire) {
  protocol::ServerCatalogue catalogue = std::move(repertoire.catalogue);
  for (std::size_t i = 0; i < std::min(repertoire.voices.size(), catalogue.streams.size()); ++i) {
    if (!repertoire.voices[i]) continue;
    auto* const stream = std::get_if<protocol::RecordedStream>(&catalogue.streams[i].kind);
    if (stream == nullptr) continue;
    protocol::SpokenTrack spoken;
    if (stream->spoken) spoken = *stream->spoken;
    spoken.voice = voices_.track_of(*repertoire.voices[i]);
    stream->spoken = std::make_shared<const protocol::SpokenTrack>(std::move(spoken));
  }
  return catalogue;
}

/// Lets streams that have not changed share the memory of those served before.
void Programme::share_with_before(protocol::ServerCatalogue& catalogue) const {
  for (protocol::ServedStream& stream : catalogue.streams) {
    auto* const recorded = std::get_if<protocol::RecordedStream>(&stream.kind);
    if (recorded == nullptr) continue;
    for (const protocol::ServedStream& other : catalogue_->streams) {
      const auto* const before = std::get_if<protocol::RecordedStream>(&other.kind);
      if (before == nullptr || stream.name != other.name) continue;
      if (*recorded->encoded != *before->encoded) continue;
      recorded->encoded = before->encoded;
      const bool same_voiced =
          recorded->voiced && before->voiced && *recorded->voiced == *before->voiced;
      if (same_voiced) recorded->voiced = before->voiced;
    }
  }
}

void Programme::describe(Status& status) const {
  const auto& served = catalogue_->streams;
  status.live = std::any_of(served.begin(), served.end(),
                            [](const auto& stream) { return stream.live() != nullptr; });
  for (const auto& stream : served) status.streams.push_back(stream.known_name());
  sources_.describe(status);
  for (UpstreamStatus& pushed : pushed_.statuses()) status.upstreams.push_back(std::move(pushed));
  status.lag_seconds = seconds(beat_.lag());
}

}  // namespace aucast::server
