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

auto find_named(const std::vector<protocol::ServedStream>& streams, const std::string& name) {
  return std::find_if(streams.begin(), streams.end(),
                      [&name](const auto& stream) { return stream.known_name() == name; });
}

/// Whether a stream was read whose name a running source has got since the start, or is to come
/// from one that was none at the start. Logs that.
bool is_misplaced(const protocol::ServedStream& read,
                  const std::vector<protocol::ServedStream>& of_sources) {
  const bool from_source =
      std::any_of(of_sources.begin(), of_sources.end(), [&](const auto& other) {
        return read.name == (read.absent() ? other.name : other.known_name());
      });
  if (read.absent() == from_source) return false;
  spdlog::error("{}: {}", read.name,
                from_source
                    ? "another source has that name now; rename the file"
                    : "it is written live now and was not at the start; restart to serve it");
  return true;
}

}  // namespace

Programme::Programme(asio::io_context& io, const TransmitterOptions& options, Repertoire repertoire,
                     Events events)
    : io_(io),
      options_(options),
      events_(std::move(events)),
      id_(random_digits(kIdDigits)),
      sources_(io, options, id_, [this](const std::string& name) { return take_name(name); },
               {[this] { on_moment_of_source(); }, [this] { renew(); }, events_.on_sight}),
      pushed_(io, {id_, options.upstream.wait, options.classic_min},
              {events_.on_moment, [this] { renew(); }}),
      beat_(io, events_.on_moment,
            {link_limits(options), options.keyframe_ms, options.classic_min}),
      voices_(io, options.voice.encoder, [this] { events_.on_voice(); }),
      held_back_max_(held_back_for(repertoire, options.voice)),
      read_(accompanied(std::move(repertoire))),
      catalogue_(std::make_shared<protocol::ServerCatalogue>()) {
  catalogue_->keyframe_ms = options.keyframe_ms;
  catalogue_->loop = options.loop;
  catalogue_->id = id_;
  catalogue_->owner_token = random_digits(kOwnerTokenDigits);
  open_to_publishers();
  renew();
}

void Programme::begin() {
  play_live(read_);
  renew();
}

/// The streams that no publisher sends: what was read, with the streams of running sources in their
/// places, and then those that such sources have got since the start.
Programme::Streams Programme::own() const {
  Streams own = read_;
  for (protocol::ServedStream& of_source : sources_.streams()) {
    const auto place = std::find_if(own.begin(), own.end(), [&of_source](const auto& stream) {
      return stream.name == of_source.name;
    });
    if (place == own.end()) {
      own.push_back(std::move(of_source));
    } else if (place->absent()) {
      *place = std::move(of_source);
    }
  }
  return own;
}

/// Lists the streams that are served; called whenever there is another one. Who is sent a stream
/// keeps it, and who waits for one looks into the list anew.
void Programme::renew() {
  Streams streams = own();
  for (protocol::ServedStream& pushed : pushed_.streams()) streams.push_back(std::move(pushed));
  catalogue_->streams = std::move(streams);
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
  const Streams streams = own();
  return find_named(streams, name) != streams.end();
}

/// Takes a name for another stream of a running source, if need be from a publisher; false if
/// another stream of our own has it.
bool Programme::take_name(const std::string& name) {
  if (is_own(name)) return false;
  pushed_.give_way(name);
  renew();
  return true;
}

std::optional<protocol::ErrorReply> Programme::publish_refused(
    const protocol::HelloAsked& hello) const {
  if (is_own(hello.publish)) {
    return protocol::ErrorReply{
        protocol::kNameTaken,
        "the stream '" + hello.publish + "' is one of this server's own; use another name"};
  }
  if (auto refusal = pushed_.refusal(hello)) return refusal;
  if (stopped_) return protocol::ErrorReply{protocol::kBusy, "the server stops"};
  return std::nullopt;
}

const protocol::ServedStream* Programme::named_or_first(const std::string& name) const {
  const Streams& streams = catalogue_->streams;
  if (streams.empty()) return nullptr;
  const auto found = find_named(streams, name);
  return found == streams.end() ? &streams.front() : &*found;
}

std::shared_ptr<const protocol::ServerCatalogue> Programme::alone(const std::string& name) const {
  auto one = std::make_shared<protocol::ServerCatalogue>();
  const protocol::ServedStream* const stream = named_or_first(name);
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

/// Whether a client that comes now may be sent a live stream, if only later.
bool Programme::may_be_live() const {
  const auto& streams = catalogue_->streams;
  return options_.live || takes_streams() ||
         std::any_of(streams.begin(), streams.end(),
                     [](const auto& stream) { return stream.live() || !stream.known(); });
}

/// Whether nothing can come any more, and nothing recorded is served.
bool Programme::over() const {
  return !takes_streams() && sources_.over() &&
         std::all_of(read_.begin(), read_.end(), [](const auto& read) { return read.absent(); });
}

void Programme::stop() {
  stopped_ = true;
  voices_.stop();
  sources_.stop();
  pushed_.stop();
  beat_.stop();
}

bool Programme::take_over(Repertoire repertoire) {
  const Streams of_sources = sources_.streams();
  std::erase_if(repertoire, [&of_sources](const OfferedStream& offered) {
    return is_misplaced(offered.stream, of_sources);
  });
  if (repertoire.empty() && of_sources.empty() && !takes_streams()) return false;
  const int held_back_max = held_back_for(repertoire, options_.voice);
  Streams read = accompanied(std::move(repertoire));
  play_live(read);
  share_with_before(read);
  for (const protocol::ServedStream& stream : read) pushed_.give_way(stream.name);
  read_ = std::move(read);
  const Streams before = catalogue_->streams;
  renew();
  if (catalogue_->streams == before) {
    spdlog::info("the sources hold what they held");
    return false;
  }
  held_back_max_ = held_back_max;
  // Who waits for a stream may find it among these.
  events_.on_moment();
  return true;
}

/// The streams with their voices, which grow from now on.
Programme::Streams Programme::accompanied(Repertoire repertoire) {
  Streams streams;
  for (OfferedStream& offered : repertoire) {
    protocol::ServedStream& stream = streams.emplace_back(std::move(offered.stream));
    auto* const recorded = std::get_if<protocol::RecordedStream>(&stream.kind);
    if (recorded == nullptr || !offered.voice) continue;
    protocol::SpokenTrack spoken;
    if (recorded->spoken) spoken = *recorded->spoken;
    spoken.voice = voices_.track_of(*offered.voice);
    recorded->spoken = std::make_shared<const protocol::SpokenTrack>(std::move(spoken));
  }
  return streams;
}

/// With --live: gives each recorded stream a channel that plays it.
void Programme::play_live(Streams& read) {
  if (!options_.live) return;
  for (protocol::ServedStream& stream : read) {
    if (const auto* const recorded = std::get_if<protocol::RecordedStream>(&stream.kind)) {
      stream.kind =
          beat_.play(stream.name, recorded->for_listeners(), options_.loop, recorded->spoken);
    }
  }
}

/// Lets streams that have not changed share the memory of those read before.
void Programme::share_with_before(Streams& read) const {
  for (protocol::ServedStream& stream : read) {
    auto* const recorded = std::get_if<protocol::RecordedStream>(&stream.kind);
    if (recorded == nullptr) continue;
    for (const protocol::ServedStream& other : read_) {
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
