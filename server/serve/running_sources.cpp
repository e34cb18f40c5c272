#include "server/serve/running_sources.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "common/log.h"
#include "common/thread.h"
#include "protocol/endpoint.h"
#include "server/engine/engine_edge.h"
#include "server/engine/nats_bus.h"
#include "server/engine/nats_options.h"
#include "server/streams/film_source.h"
#include "server/streams/source_path.h"
#include "server/upstream/dialled_address.h"
#include "server/upstream/dialled_upstream.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

LinkLimits link_limits(const TransmitterOptions& options) {
  return {options.max_kbits, options.batch, voice_kbits(options.voice.encoder),
          options.voice.encoder.frame};
}

RunningSources::RunningSources(asio::io_context& io, const TransmitterOptions& options,
                               std::string id, RelayedStream::TakeName take_name, Events events)
    : io_(io),
      options_(options),
      id_(std::move(id)),
      take_name_(std::move(take_name)),
      events_(std::move(events)) {}

Result<void> RunningSources::open(const GivenUp& given_up) {
  auto conditioning = conditioning_of(options_.source.signal);
  if (!conditioning) return conditioning.error();
  conditioning_ = *std::move(conditioning);
  for (const std::filesystem::path& path : options_.sources) {
    Result<void> opened;
    if (protocol::is_stream_address(path.string())) {
      opened = open_dialled(path.string());
    } else if (protocol::is_engine_address(path.string())) {
      opened = open_edge(path.string());
    } else if (is_live(path, options_.live_source.follow)) {
      opened = open_live(path, given_up);
    }
    if (!opened) return opened;
  }
  return {};
}

/// How each stream of a source that is being written is served.
Result<LiveStreamOptions> RunningSources::stream_options(const std::filesystem::path& path,
                                                         bool voice) const {
  LiveStreamOptions stream;
  stream.path = path;
  stream.reader = {options_.source.recording, options_.source.rate,
                   conditioning_for(path, conditioning_), options_.keyframe_ms};
  stream.classic_min = options_.classic_min;
  stream.timeout = options_.live_source.timeout;
  stream.link = link_limits(options_);
  stream.voice = voice;
  if (!voice) return stream;
  const auto kbits = face_kbits(options_.max_kbits, options_.voice.encoder, path);
  if (!kbits) return kbits.error();
  stream.encoder = options_.voice.encoder;
  stream.voice_delay = options_.voice.delay;
  return stream;
}

Result<void> RunningSources::open_live(const std::filesystem::path& path, const GivenUp& given_up) {
  const bool first = path == options_.sources.front();
  const bool voice = first && !options_.voice.none && !options_.voice.file.empty();
  auto each = stream_options(path, voice);
  if (!each) return each.error();
  LiveStreamsOptions streams{*std::move(each), options_.live_source.follow, options_.record,
                             live_.empty(), take_name_};
  auto source = std::make_unique<LiveSource>(
      io_,
      LiveSourceOptions{std::move(streams), voice ? options_.voice.file : std::filesystem::path(),
                        options_.source.camera, faces_of(options_.source), events_.on_sight,
                        given_up},
      LiveStreams::Events{events_.on_moment, events_.on_face,
                          [this](const auto& neutral) { on_neutral(neutral); }});
  if (auto begun = source->start(); !begun) return begun;
  live_.push_back(std::move(source));
  return {};
}

Result<void> RunningSources::open_dialled(const std::string& address) {
  auto from =
      dialled_address(address, {options_.upstream.token, options_.upstream.tls, "--upstream-tls"});
  if (!from) return from.error();
  auto options = reception(from->address.stream, "parent");
  return begin(std::make_unique<DialledUpstream>(io_, *std::move(from), std::move(options),
                                                 events_.on_moment));
}

Result<void> RunningSources::open_edge(const std::string& address) {
  const auto nats = nats_options(address, options_.engine);
  if (!nats) return nats.error();
  const auto open = [&io = io_, nats = *nats](Bus::Events events) {
    return open_nats_bus(io, nats, std::move(events));
  };
  return begin(std::make_unique<EngineEdge>(io_, reception(nats->address.stream, "origin"), open,
                                            events_.on_moment));
}

Reception::Options RunningSources::reception(const std::string& name, const char* sender) const {
  return {name, id_, options_.upstream.wait, options_.classic_min, sender, take_name_};
}

Result<void> RunningSources::begin(std::unique_ptr<Upstream> upstream) {
  upstreams_.push_back(std::move(upstream));
  return upstreams_.back()->start();
}

/// On a thread of its own, so that no client waits for a disk. The face is measured again when a
/// source turns out to have another scale; what was measured last is written last.
void RunningSources::on_neutral(const sources::MeasuredNeutral& neutral) {
  const std::filesystem::path& file = options_.source.signal.save_profile;
  if (file.empty()) return;
  auto before = std::make_shared<std::jthread>(std::move(saving_));
  auto saving = start_thread([file, settings = conditioning_, neutral, before] {
    if (before->joinable()) before->join();
    if (const auto saved = save_profile(file, settings, neutral); !saved) {
      spdlog::error("{}", saved.error().message);
    } else {
      spdlog::info("the profile was written to {}", file.string());
    }
  });
  if (saving) {
    saving_ = std::move(*saving);
  } else {
    saving_ = std::move(*before);
    spdlog::error("{}: not written: {}", file.string(), saving.error().message);
  }
}

void RunningSources::stop() {
  for (const auto& source : live_) source->stop();
  for (const auto& upstream : upstreams_) upstream->stop();
}

bool RunningSources::over() const {
  return upstreams_.empty() && std::all_of(live_.begin(), live_.end(), [](const auto& source) {
           return source->streams().over();
         });
}

std::vector<protocol::ServedStream> RunningSources::streams() const {
  std::vector<protocol::ServedStream> all;
  for (const auto& source : live_) {
    for (protocol::ServedStream& stream : source->streams().served())
      all.push_back(std::move(stream));
  }
  for (const auto& upstream : upstreams_) all.push_back(upstream->reception().served());
  return all;
}

void RunningSources::condition(const sources::ConditioningSettings& settings) {
  if (options_.source.signal.profile.empty() || live_.empty()) return;
  conditioning_ = settings;
  for (const auto& source : live_) source->streams().condition(settings);
  spdlog::info("the profile was read again");
}

void RunningSources::describe(Status& status) const {
  for (const auto& upstream : upstreams_) upstream->describe(status);
}

Result<void> RunningSources::finish() {
  if (saving_.joinable()) saving_.join();
  std::optional<Error> first;
  for (const auto& source : live_) {
    // Every record is finished, whatever has become of another.
    if (auto finished = source->finish(); !finished && !first) first = finished.error();
  }
  if (first) return *first;
  return {};
}

}  // namespace aucast::server
