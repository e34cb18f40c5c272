#include "server/catalogue.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/check.h"
#include "common/files.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::server {
namespace {

Result<Source> load_source(const std::filesystem::path& path) {
  Source source{path, path.stem().string(), {}};
  if (!protocol::is_stream_name(source.name)) {
    return Error{ErrorKind::Usage,
                 path.string() + ": '" + escaped(source.name) +
                     "' cannot be a stream's name; rename the file: 1 to 64 letters, digits, "
                     "'.', '_' or '-' before the extension"};
  }
  const auto text = read_file(path);
  if (!text) return text.error();
  auto stream = protocol::parse_stream_file(*text, path.string());
  if (!stream) return stream.error();
  source.stream = std::move(*stream);
  return source;
}

std::optional<Error> taken_name(const std::vector<Source>& sources, const Source& source) {
  const auto other = std::find_if(sources.begin(), sources.end(), [&](const Source& candidate) {
    return candidate.name == source.name;
  });
  if (other == sources.end()) return std::nullopt;
  return Error{ErrorKind::Usage, source.path.string() + ": a stream named '" + source.name +
                                     "' comes from " + other->path.string() +
                                     " already; leave one out or rename a file"};
}

protocol::ServedStream served(const Source& source, const CatalogueOptions& options) {
  protocol::ServedStream stream;
  stream.name = source.name;
  for (const protocol::Keyframe& keyframe : source.stream.keyframes) {
    stream.classic.push_back(protocol::encode_classic(keyframe, options.classic_min));
    stream.negotiated.push_back(protocol::encode(keyframe));
  }
  // A stream that starts again has no length.
  if (!options.loop) stream.duration_ms = protocol::media_ms(source.stream, options.keyframe_ms);
  return stream;
}

}  // namespace

Result<std::vector<Source>> load_sources(const std::vector<std::filesystem::path>& paths) {
  std::vector<Source> sources;
  std::optional<Error> errors;
  const auto note = [&errors](const Error& error) {
    if (errors) {
      errors->message += "\n" + error.message;
    } else {
      errors = error;
    }
  };
  for (const std::filesystem::path& path : paths) {
    auto source = load_source(path);
    if (!source) {
      note(source.error());
    } else if (const auto taken = taken_name(sources, *source)) {
      note(*taken);
    } else {
      sources.push_back(std::move(*source));
    }
  }
  if (errors) return *errors;
  return sources;
}

protocol::ServerCatalogue make_catalogue(const std::vector<Source>& sources,
                                         const CatalogueOptions& options) {
  AUCAST_CHECK(!sources.empty());
  protocol::ServerCatalogue catalogue;
  catalogue.keyframe_ms = options.keyframe_ms;
  catalogue.loop = options.loop;
  for (const Source& source : sources) catalogue.streams.push_back(served(source, options));
  return catalogue;
}

}  // namespace aucast::server
