#include "server/streams/load_repertoire.h"

#include <algorithm>
#include <string>
#include <utility>

#include "common/log.h"
#include "common/sources/found_report.h"
#include "protocol/codec.h"
#include "server/streams/measured_profile.h"
#include "server/streams/source_warnings.h"

namespace aucast::server {
namespace {

/// Which sources are live when they are served; --check reads all of them whole.
LiveKinds live_sources(const TransmitterOptions& options) {
  if (options.check || options.estimate) return LiveKinds::None;
  return options.live_source.follow ? LiveKinds::Files : LiveKinds::Streams;
}

EncodingOptions encoding_of(const TransmitterOptions& options) {
  return {options.keyframe_ms, options.classic_min,
          options.max_kbits,   options.check && !options.estimate,
          options.voice,       options.live && !options.check && !options.estimate};
}

protocol::StreamList names_of(const std::vector<Source>& sources) {
  protocol::StreamList list;
  for (const Source& source : sources) {
    if (!source.name.empty()) list.streams.push_back({source.name});
  }
  return list;
}

void say_what_was_found(const std::vector<Source>& sources) {
  for (const Source& source : sources) {
    if (source.found) {
      spdlog::info("{}: {}", source.path.string(), sources::found_sentence(*source.found));
    }
  }
}

void warn_of_cut_list(const std::vector<Source>& sources) {
  const protocol::StreamList list = names_of(sources);
  const std::size_t shown = listed(sources);
  if (shown == list.streams.size()) return;
  spdlog::warn(
      "the list of {} streams is cut after '{}', for it is one packet: --list shows {}, "
      "--stream plays the others too",
      list.streams.size(), list.streams[shown - 1].name, shown);
}

}  // namespace

Result<std::vector<Source>> load_asked(const TransmitterOptions& options,
                                       const sources::ConditioningSettings& conditioning,
                                       const std::stop_token& stop) {
  std::vector<Error> skipped;
  auto sources = load_sources(options.sources, options.source, encoding_of(options), conditioning,
                              options.skip_bad ? &skipped : nullptr, live_sources(options), stop);
  for (const Error& error : skipped) {
    log_lines(spdlog::level::warn, "left out: ", error.message);
  }
  if (sources) {
    for (const std::string& warning : source_warnings(*sources, options.source)) {
      spdlog::warn("{}", warning);
    }
  }
  return sources;
}

Result<LoadedSources> load_repertoire(const TransmitterOptions& options,
                                      const std::stop_token& stop) {
  auto conditioning = conditioning_of(options.source.signal);
  if (!conditioning) return conditioning.error();
  const auto sources = load_asked(options, *conditioning, stop);
  if (!sources) return sources.error();
  auto repertoire = make_repertoire(*sources);
  if (options.live && options.loop) {
    if (auto can = check_live_loop(repertoire); !can) return can.error();
  }
  say_what_was_found(*sources);
  if (auto saved = save_measured_profile(options.source.signal, *conditioning, *sources); !saved) {
    return saved.error();
  }
  warn_of_cut_list(*sources);
  return LoadedSources{std::move(repertoire), *std::move(conditioning)};
}

std::size_t listed(const std::vector<Source>& sources) {
  // Each name that there is room for comes after a blank.
  const std::string packet = protocol::encode(names_of(sources));
  return static_cast<std::size_t>(std::count(packet.begin(), packet.end(), ' '));
}

}  // namespace aucast::server
