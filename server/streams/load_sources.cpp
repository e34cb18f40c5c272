#include "server/streams/load_sources.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/film_name.h"
#include "common/memory.h"
#include "common/sources/content.h"
#include "common/sources/dead_band.h"
#include "common/sources/source_reader.h"
#include "common/stopped.h"
#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/encoded_stream.h"
#include "protocol/endpoint.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"
#include "protocol/voiced_stream.h"
#include "server/streams/film_source.h"
#include "server/streams/resampling.h"
#include "server/streams/source_path.h"
#include "server/streams/thinning.h"
#include "server/voice/accompaniment.h"

namespace aucast::server {
namespace {

constexpr std::string_view kServeLess = "serve a shorter stream";

Result<void> check_name(const std::filesystem::path& path, const std::string& name) {
  if (protocol::is_stream_name(name)) return {};
  return Error{ErrorKind::Usage,
               at_place(path.string(), "'" + escaped(name) +
                                           "' cannot be a stream's name; rename the file: " +
                                           protocol::kStreamNameRule + " before the extension")};
}

/// After how many keyframes the free memory is checked again.
constexpr std::size_t kMemoryLookEvery = 65536;

/// What all files of one call have in common.
struct Reading {
  const SourceOptions& source;
  const sources::ConditioningSettings& conditioning;
  const EncodingOptions& encoding;
  LiveKinds live = LiveKinds::None;
  bool first = false;  ///< it is the first source, to which --voice applies
  const std::stop_token& stop;
};

/// Encodes a stream file as it is, keyframe by keyframe, so that only its packets are kept in
/// memory.
Result<void> encode_file(std::string_view text, const Reading& reading, Source& source) {
  const EncodingOptions& options = reading.encoding;
  protocol::StreamEncoder encoder(options.keyframe_ms, options.classic_min);
  const auto encode = [&](const protocol::Keyframe& keyframe) -> Result<void> {
    if (reading.stop.stop_requested()) return stopped_early();
    if (options.summarise) source.summary.add(keyframe, options.keyframe_ms);
    encoder.add(keyframe);
    // As much again is taken for a moment when the buffers grow.
    if (encoder.keyframes() % kMemoryLookEvery != 0) return {};
    return check_memory(source.path, encoder.bytes(), kServeLess);
  };
  if (auto read = protocol::read_stream_file(text, sources::name_of(source.path), encode); !read) {
    return read;
  }
  source.stream = std::make_shared<const protocol::EncodedStream>(encoder.finish());
  return {};
}

/// Moves a recording's voice: the face begins to move to the first row when the stream begins, so
/// the row's time, and with it the beginning of the sound, is the end of that keyframe.
void align_voice(const protocol::StreamFile& stream, std::uint32_t keyframe_ms, Source& source) {
  if (!source.voice) return;
  source.voice->begin += Milliseconds(stream.keyframes.front().time_ms.value_or(keyframe_ms));
}

/// Encodes a stream that is in memory as keyframes; resamples and thins it if asked to.
Result<void> encode_whole(sources::SourceContent content, const Reading& reading, Source& source) {
  const EncodingOptions& options = reading.encoding;
  protocol::StreamFile& stream = content.stream;
  if (content.found) align_voice(stream, options.keyframe_ms, source);
  if (const auto rate = reading.source.rate) {
    auto done = resample(stream, *rate, options.keyframe_ms, source.path, reading.stop);
    if (!done) return done;
  }
  if (content.found) {
    sources::apply_dead_band(stream, reading.conditioning.profile.dead_band);
  }
  if (options.max_kbits != 0) {
    std::uint32_t kbits = options.max_kbits;
    if (source.voice) {
      const auto left = face_kbits(kbits, options.voice.encoder, source.path);
      if (!left) return left.error();
      kbits = *left;
    }
    const bool when_sent = source.voice && options.live;
    if (!when_sent) {
      stream.keyframes = thinned(stream.keyframes, options.keyframe_ms, kbits, reading.stop);
    }
  }
  if (options.summarise) {
    for (const protocol::Keyframe& keyframe : stream.keyframes) {
      source.summary.add(keyframe, options.keyframe_ms);
    }
  }
  source.stream = std::make_shared<const protocol::EncodedStream>(protocol::encode_stream(
      stream.keyframes, options.keyframe_ms, options.classic_min, reading.stop));
  source.found = std::move(content.found);
  return {};
}

/// Whether it is the address of another server's stream.
bool is_address(const std::filesystem::path& path) {
  return protocol::is_stream_address(path.string()) || protocol::is_engine_address(path.string());
}

/// A stream of another server, of which only the name in its address is known yet.
Result<std::vector<Source>> address_source(const std::filesystem::path& path, LiveKinds live) {
  const auto address = protocol::is_engine_address(path.string())
                           ? protocol::parse_engine_address(path.string())
                           : protocol::parse_stream_address(path.string());
  if (!address) return address.error();
  if (live == LiveKinds::None) {
    return Error{ErrorKind::Usage,
                 at_place(path.string(), "--check and --estimate read files; leave it out")};
  }
  return std::vector<Source>{{.path = path, .name = address->stream, .live = true}};
}

/// Completes a source whose stream is encoded. Fails if that is longer than the protocol can tell.
Result<void> complete(const EncodingOptions& options, Source& source) {
  if (source.stream->duration_ms.value_or(0) > protocol::kPlaceMsMax) {
    return Error{ErrorKind::BadData,
                 at_place(source.path.string(), "the stream lasts longer than the " +
                                                    std::to_string(protocol::kPlaceMsMax) +
                                                    " ms that the protocol can tell; divide it")};
  }
  if (!source.voice) return {};
  const Milliseconds end = source.voice->begin + source.voice->duration;
  if (end <= Milliseconds::zero()) {
    return Error{ErrorKind::Usage,
                 at_place(source.voice->path.string(),
                          "--voice-delay " + std::to_string(options.voice.delay.count()) +
                              " leaves nothing of a sound of " +
                              std::to_string(source.voice->duration.count()) + " ms")};
  }
  source.voiced =
      protocol::voiced_stream(*source.stream, end, options.keyframe_ms, options.classic_min);
  return {};
}

/// The streams of one file: one, or one for each face.
Result<std::vector<Source>> load_source(const std::filesystem::path& path, const Reading& reading) {
  if (is_address(path)) {
    return address_source(path, reading.live);
  }
  std::vector<Source> streams;
  const std::string stem = stream_name(path);
  if (auto can = check_name(path, stem); !can) return can.error();
  if (reading.live != LiveKinds::None && is_live(path, reading.live == LiveKinds::Files)) {
    streams.push_back({.path = path, .name = stem, .live = true});
    return streams;
  }
  if (camera_device(path)) {
    return Error{ErrorKind::Usage,
                 "a camera is live: it can be served, not described; leave it out"};
  }
  const bool film = is_film(path);
  const auto text = film ? film_text(path, reading.source, {}, reading.stop)
                         : sources::read_text(path, reading.stop);
  if (!text) return text.error();
  const auto beside = accompaniment_of(path, reading.encoding.voice, reading.first);
  if (!beside) return beside.error();
  const bool is_stream_file = sources::content_kind(*text) == sources::ContentKind::StreamFile;
  const auto source_named = [&](const std::string& name) {
    return Source{
        .path = path,
        .name = name,
        .voice = beside->voice,
        .captions = beside->captions,
        .title = is_stream_file ? protocol::stream_title(*text) : protocol::StreamTitle()};
  };
  if (is_stream_file && !reading.source.rate && reading.encoding.max_kbits == 0) {
    streams.push_back(source_named(stem));
    auto read = encode_file(*text, reading, streams.front());
    if (!read) return read.error();
    if (auto done = complete(reading.encoding, streams.front()); !done) return done.error();
    return streams;
  }
  const std::uint64_t lines = sources::lines_of(*text);
  auto fits = check_memory(path, lines * sources::kWholeKeyframeBytes, kServeLess);
  if (!fits) return fits.error();
  auto contents =
      sources::parse_streams(*text, sources::name_of(path), reading.source.recording,
                             conditioning_for(path, reading.conditioning), reading.stop);
  if (!contents) return contents.error();
  for (sources::SourceContent& content : *contents) {
    const bool one_of_several = content.found && content.found->all_taken;
    const std::string name = one_of_several ? face_stream_name(stem, content.found->face) : stem;
    if (auto can = check_name(path, name); !can) return can.error();
    streams.push_back(source_named(name));
    auto encoded = encode_whole(std::move(content), reading, streams.back());
    if (!encoded) return encoded.error();
    if (auto done = complete(reading.encoding, streams.back()); !done) return done.error();
  }
  return streams;
}

/// A folder may hold a README too.
bool is_served_from_folder(const std::filesystem::path& path) {
  const std::string extension = file_ending(path);
  return (extension == ".txt" || extension == ".csv") && !path.filename().string().starts_with('.');
}

/// The files of a folder, by name; for a file, the file itself.
Result<std::vector<std::filesystem::path>> files_of(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(path, error)) return std::vector<fs::path>{path};
  std::vector<fs::path> files;
  for (fs::directory_iterator next(path, error), end; !error && next != end;
       next.increment(error)) {
    std::error_code unknown;  // a file that cannot be looked at is said when it is read
    if (is_served_from_folder(next->path()) && !next->is_directory(unknown)) {
      files.push_back(next->path());
    }
  }
  if (error) {
    return Error{ErrorKind::Unreadable,
                 at_place(path.string(), "cannot be read: " + error.message())};
  }
  if (files.empty()) {
    return Error{ErrorKind::BadData,
                 at_place(path.string(),
                          "there is no .txt or .csv file in this folder; films and other files "
                          "are named one by one")};
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// One error with the messages of all of them.
Error joined(const std::vector<Error>& errors) {
  Error all = errors.front();
  for (auto error = errors.begin() + 1; error != errors.end(); ++error) {
    all.message += "\n" + error->message;
  }
  return all;
}

std::optional<Error> taken_name(const std::vector<Source>& sources, const Source& source) {
  const auto other = std::find_if(sources.begin(), sources.end(), [&](const Source& candidate) {
    return candidate.name == source.name;
  });
  if (other == sources.end()) return std::nullopt;
  if (source.name.empty()) {
    return Error{ErrorKind::Usage, at_place(source.path.string(),
                                            "only one address may leave the stream's name out")};
  }
  const char* const remedy = !is_address(source.path) ? "; leave one out or rename a file"
                             : !is_address(other->path)
                                 ? "; rename the file"
                                 : "; leave one out, or name two hosts of one "
                                   "stream in one address, HOST,HOST/NAME";
  return Error{
      ErrorKind::Usage,
      at_place(source.path.string(), "a stream named '" + source.name + "' comes from " +
                                         printable(other->path.string()) + " already" + remedy)};
}

}  // namespace

Result<std::vector<Source>> load_sources(const std::vector<std::filesystem::path>& paths,
                                         const SourceOptions& options,
                                         const EncodingOptions& encoding,
                                         const sources::ConditioningSettings& conditioning,
                                         std::vector<Error>* skipped, LiveKinds live,
                                         const std::stop_token& stop) {
  std::vector<Source> sources;
  std::vector<Error> errors;
  for (const std::filesystem::path& path : paths) {
    const auto files = files_of(path);
    if (!files) {
      errors.push_back(files.error());
      continue;
    }
    for (const std::filesystem::path& file : *files) {
      const bool first = &path == &paths.front() && &file == &files->front();
      auto streams = load_source(file, {options, conditioning, encoding,
                                        file == path ? live : LiveKinds::None, first, stop});
      if (stop.stop_requested()) return stopped_early();
      if (!streams) {
        errors.push_back(streams.error());
        continue;
      }
      for (Source& source : *streams) {
        if (auto taken = taken_name(sources, source)) {
          errors.push_back(std::move(*taken));
        } else {
          sources.push_back(std::move(source));
        }
      }
    }
  }
  if (skipped != nullptr && !sources.empty()) {
    *skipped = std::move(errors);
    return sources;
  }
  if (!errors.empty()) return joined(errors);
  return sources;
}

}  // namespace aucast::server
