#include "server/streams/source_warnings.h"

#include <algorithm>
#include <utility>

#include "protocol/endpoint.h"
#include "protocol/stream_file.h"

namespace aucast::server {
namespace {

/// What comes live may be the table of a recogniser.
bool may_be_recording(const Source& source) {
  const std::string path = source.path.string();
  const bool elsewhere = protocol::is_stream_address(path) || protocol::is_engine_address(path);
  return source.found.has_value() || (source.live && !elsewhere);
}

}  // namespace

std::vector<std::string> source_warnings(const std::vector<Source>& sources,
                                         const SourceOptions& options) {
  std::vector<std::string> warnings;
  for (const Source& source : sources) {
    std::string wrong = protocol::title_complaint(source.title, source.path.string());
    if (!wrong.empty()) warnings.push_back(std::move(wrong));
  }
  const std::string unused = options_of_recordings(options);
  if (!unused.empty() && !sources.empty() &&
      std::none_of(sources.begin(), sources.end(), may_be_recording)) {
    warnings.push_back("nothing is changed by " + unused +
                       ": no SOURCE is the table of a recogniser, a film or a camera");
  }
  return warnings;
}

}  // namespace aucast::server
