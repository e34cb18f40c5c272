#include "server/serve/programme.h"

#include <algorithm>
#include <random>
#include <string_view>
#include <utility>

#include <asio/post.hpp>

#include "common/log.h"
#include "protocol/endpoint.h"
#include "protocol/limits.h"
#include "server/engine/nats_bus.h"
#include "server/engine/nats_options.h"
#include "server/streams/catalogue.h"
#include "server/streams/film_source.h"
#include "server/streams/source_path.h"
#include "server/upstream/upstream_options.h"

namespace aucast::server {
namespace {

/// Of a live stream, what the system may hold back unsent for one client: some time's worth, but
/// not so little that every packet has to wait for the one before.
constexpr std::size_t kUnsentBytesLeast = 512;
constexpr std::size_t kUnsentBytesMost = 65536;
constexpr std::size_t kUnsentBytesOfSources = 2048;  ///< what they will send is not known

int unsent_bytes_for(const protocol::ServerCatalogue& catalogue, const VoiceOptions& voice) {
  constexpr Milliseconds kTime = protocol::kLiveWindowTime / 2;
  const bool any_voice =
      std::any_of(catalogue.streams.begin(), catalogue.streams.end(),
                  [](const auto& stream) { return stream.sound && stream.sound->voice; });
  // Kilobits a second are bits a millisecond.
  const std::size_t of_voice =
      any_voice ? voice_kbits(voice.encoder) * static_cast<std::size_t>(kTime.count()) / 8 : 0;
  const std::size_t bytes = bytes_in(catalogue, kTime) + of_voice;
  const bool unknown = std::any_of(catalogue.streams.begin(), catalogue.streams.end(),
                                   [](const auto& stream) { return !stream.recorded; });
  const std::size_t least = unknown ? kUnsentBytesOfSources : kUnsentBytesLeast;
  return static_cast<int>(std::clamp(bytes, least, kUnsentBytesMost));
}

bool same_streams(const protocol::ServerCatalogue& a, const protocol::ServerCatalogue& b) {
  return std::equal(a.streams.begin(), a.streams.end(), b.streams.begin(), b.streams.end(),
                    [](const auto& one, const auto& other) {
                      return one.name == other.name && one.recorded == other.recorded &&
                             one.live == other.live && one.upstream == other.upstream &&
                             same_sound(one.sound, other.sound) && one.spoken == other.spoken &&
                             one.title == other.title;
                    });
}

LinkLimits link_limits(const TransmitterOptions& options) {
  return {options.max_kbits, options.batch, voice_kbits(options.voice.encoder),
          options.voice.encoder.frame};
}

/// By which relays find loops.
std::string random_id() {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::random_device random;
  std::string id;
  while (id.size() < 12) id += kDigits[random() % kDigits.size()];
  return id;
}

}  // namespace

Programme::Programme(asio::io_context& io, const TransmitterOptions& options, Repertoire repertoire,
                     Events events)
    : io_(io),
      options_(options),
      events_(std::move(events)),
      beat_(io, events_.on_moment,
            {link_limits(options), options.keyframe_ms, options.classic_min}),
      voices_(io, options.voice.encoder, [this] { events_.on_voice(); }),
      catalogue_(std::make_shared<protocol::ServerCatalogue>(accompanied(std::move(repertoire)))),
      unsent_bytes_max_(unsent_bytes_for(*catalogue_, options.voice)) {
  catalogue_->id = random_id();
}

Result<void> Programme::open_sources() {
  const auto conditioning = conditioning_of(options_.source.signal);
  if (!conditioning) return conditioning.error();
  for (const std::filesystem::path& path : options_.sources) {
    if (protocol::is_stream_address(path.string())) {
      if (auto opened = open_upstream(path.string()); !opened) return opened;
      continue;
    }
    if (protocol::is_engine_address(path.string())) {
      if (auto opened = open_edge(path.string()); !opened) return opened;
      continue;
    }
    if (!is_live(path, options_.live_source.follow)) continue;
    if (auto opened = open(path, *conditioning); !opened) return opened;
  }
  return {};
}

Result<void> Programme::open(const std::filesystem::path& path,
                             const sources::ConditioningSettings& conditioning) {
  const sources::LiveOptions reader{options_.source.recording, options_.source.rate,
                                    conditioning_for(path, conditioning), options_.keyframe_ms};
  LiveSourceOptions source_options;
  source_options.path = path;
  source_options.follow = options_.live_source.follow;
  source_options.reader = reader;
  source_options.classic_min = options_.classic_min;
  source_options.timeout = options_.live_source.timeout;
  source_options.record = options_.record;
  source_options.record_first = sources_.empty();
  source_options.link = link_limits(options_);
  const bool first = path == options_.sources.front();
  if (first && !options_.voice.none && !options_.voice.file.empty()) {
    const auto kbits = face_kbits(options_.max_kbits, options_.voice.encoder, path);
    if (!kbits) return kbits.error();
    source_options.voice = options_.voice.file;
    source_options.encoder = options_.voice.encoder;
    source_options.voice_delay = options_.voice.delay;
  }
  source_options.camera = options_.source.camera;
  source_options.quiet = quiet_of(options_.source.signal);
  source_options.on_neutral = [this](const auto& neutral) { on_neutral(neutral); };
  auto source = std::make_unique<LiveSource>(io_, std::move(source_options),
                                             LiveStreams::Events{[this] { on_moment_of_source(); },
                                                                 [this] {
                                                                   if (!stopped_)
                                                                     make_live(*catalogue_);
                                                                 }});
  if (auto begun = source->start(); !begun) return begun;
  sources_.push_back(std::move(source));
  return {};
}

Result<void> Programme::open_upstream(const std::string& address) {
  auto upstream = upstream_options(address, options_.upstream);
  if (!upstream) return upstream.error();
  upstream->id = catalogue_->id;
  upstream->classic_min = options_.classic_min;
  upstreams_.push_back(std::make_unique<Upstream>(io_, *std::move(upstream), events_.on_moment));
  upstreams_.back()->start();
  return {};
}

Result<void> Programme::open_edge(const std::string& address) {
  const auto nats = nats_options(address, options_.engine);
  if (!nats) return nats.error();
  const EngineEdge::Options options{nats->address.stream, catalogue_->id, options_.upstream.wait,
                                    options_.classic_min};
  edges_.push_back(std::make_unique<EngineEdge>(io_, options, events_.on_moment));
  return edges_.back()->start(
      [this, &nats](Bus::Events events) { return open_nats_bus(io_, *nats, std::move(events)); });
}

void Programme::on_neutral(const sources::MeasuredNeutral& neutral) {
  const SignalOptions& signal = options_.source.signal;
  if (signal.save_profile.empty()) return;
  if (const auto saved = save_profile(signal, neutral); !saved) {
    spdlog::error("{}", saved.error().message);
  } else {
    spdlog::info("the profile was written to {}", signal.save_profile.string());
  }
}

void Programme::on_moment_of_source() {
  events_.on_moment();
  // Not now: it is a source that calls.
  if (over()) asio::post(io_, events_.on_over);
}

/// Gives each stream that is to be live its channel: of a source its feed, of a recording, with
/// --live, one that plays it. A source's faces have streams too, but for names that are taken.
void Programme::make_live(protocol::ServerCatalogue& catalogue) {
  for (protocol::ServedStream& stream : catalogue.streams) {
    if (stream.recorded && options_.live) {
      const auto recorded = std::exchange(stream.recorded, nullptr);
      const auto spoken = std::exchange(stream.spoken, nullptr);
      stream.live = beat_.play(stream.name, spoken ? spoken : recorded, options_.loop,
                               std::exchange(stream.sound, nullptr));
    }
  }
  for (protocol::ServedStream& of_source : streams_of_sources()) {
    const auto same =
        std::find_if(catalogue.streams.begin(), catalogue.streams.end(),
                     [&of_source](const auto& stream) { return stream.name == of_source.name; });
    if (same == catalogue.streams.end()) {
      catalogue.streams.push_back(std::move(of_source));
    } else if (!same->recorded && !same->live) {
      same->live = std::move(of_source.live);
      same->upstream = std::move(of_source.upstream);
    }
  }
  std::erase_if(catalogue.streams, [](const protocol::ServedStream& stream) {
    const bool nothing = !stream.known() && !stream.upstream;
    if (nothing) {
      spdlog::error("{}: it is written live now and was not at the start; restart to serve it",
                    stream.name);
    }
    return nothing;
  });
}

std::vector<protocol::ServedStream> Programme::streams_of_sources() const {
  std::vector<protocol::ServedStream> all;
  for (const auto& source : sources_) {
    for (protocol::ServedStream& stream : source->streams().served())
      all.push_back(std::move(stream));
  }
  for (const auto& upstream : upstreams_) all.push_back(upstream->stream());
  for (const auto& edge : edges_) all.push_back(edge->stream());
  return all;
}

/// Asked at every keyframe: while a source lasts, no list of streams is made.
bool Programme::over() const {
  if (!upstreams_.empty() || !edges_.empty()) return false;
  if (!std::all_of(sources_.begin(), sources_.end(),
                   [](const auto& source) { return source->streams().over(); })) {
    return false;
  }
  const auto of_sources = streams_of_sources();
  const auto& served = catalogue_->streams;
  return std::all_of(served.begin(), served.end(), [&of_sources](const auto& stream) {
    return std::any_of(of_sources.begin(), of_sources.end(),
                       [&stream](const auto& other) { return other.live == stream.live; });
  });
}

void Programme::stop() {
  stopped_ = true;
  voices_.stop();
  for (const auto& source : sources_) source->stop();
  for (const auto& upstream : upstreams_) upstream->stop();
  for (const auto& edge : edges_) edge->stop();
  beat_.stop();
}

bool Programme::take_over(Repertoire repertoire) {
  protocol::ServerCatalogue loaded = accompanied(std::move(repertoire));
  const int unsent_bytes_max = unsent_bytes_for(loaded, options_.voice);
  make_live(loaded);
  if (loaded.streams.empty()) return false;
  share_with_before(loaded);
  if (same_streams(loaded, *catalogue_)) {
    spdlog::info("the sources hold what they held");
    return false;
  }
  loaded.token = catalogue_->token;
  loaded.id = catalogue_->id;
  catalogue_ = std::make_shared<protocol::ServerCatalogue>(std::move(loaded));
  unsent_bytes_max_ = unsent_bytes_max;
  return true;
}

/// The streams with their voices, which grow from now on.
protocol::ServerCatalogue Programme::accompanied(Repertoire repertoire) {
  protocol::ServerCatalogue catalogue = std::move(repertoire.catalogue);
  for (std::size_t i = 0; i < std::min(repertoire.voices.size(), catalogue.streams.size()); ++i) {
    if (!repertoire.voices[i]) continue;
    protocol::ServedStream& stream = catalogue.streams[i];
    protocol::Soundtrack sound;
    if (stream.sound) sound = *stream.sound;
    sound.voice = voices_.track_of(*repertoire.voices[i]);
    stream.sound = std::make_shared<const protocol::Soundtrack>(std::move(sound));
  }
  return catalogue;
}

/// What a stream held before is held once.
void Programme::share_with_before(protocol::ServerCatalogue& catalogue) const {
  for (protocol::ServedStream& stream : catalogue.streams) {
    for (const protocol::ServedStream& before : catalogue_->streams) {
      const bool same = stream.recorded && before.recorded && stream.name == before.name &&
                        *stream.recorded == *before.recorded;
      if (!same) continue;
      stream.recorded = before.recorded;
      const bool same_spoken = stream.spoken && before.spoken && *stream.spoken == *before.spoken;
      if (same_spoken) stream.spoken = before.spoken;
    }
  }
}

void Programme::condition_sources_anew() {
  if (options_.source.signal.profile.empty() || sources_.empty()) return;
  const auto conditioning = conditioning_of(options_.source.signal);
  if (!conditioning) {
    spdlog::error("{}; the profile in use stays", conditioning.error().message);
    return;
  }
  for (const auto& source : sources_) source->streams().condition(*conditioning);
  spdlog::info("the profile was read again");
}

void Programme::describe(Status& status) const {
  status.live = any_live();
  for (const auto& stream : catalogue_->streams) status.streams.push_back(stream.known_name());
  for (const auto& upstream : upstreams_) status.upstreams.push_back(upstream->status());
  for (const auto& edge : edges_) status.upstreams.push_back(edge->status());
  status.lag_seconds = seconds(beat_.lag());
}

Result<void> Programme::finish() {
  Result<void> finished;
  for (const auto& source : sources_) {
    LiveStreams& streams = source->streams();
    if (auto recorded = streams.finish_record(); !recorded) finished = recorded.error();
    if (streams.over() && streams.nothing_came()) {
      finished = Error{ErrorKind::BadData,
                       streams.served().front().name + ": the source ended before a keyframe came"};
    }
  }
  return finished;
}

}  // namespace aucast::server
