#include "server/streams/source_warnings.h"

#include <algorithm>

#include "common/text.h"
#include "protocol/caption.h"
#include "protocol/endpoint.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

std::string title_left_out(const Source& source) {
  const std::string& title = source.title.text;
  const std::string why = title.size() > protocol::kTitleBytesMax
                              ? "it has " + std::to_string(title.size()) + " bytes, of at most " +
                                    std::to_string(protocol::kTitleBytesMax)
                              : "it is no plain UTF-8 text";
  return at_place(source.path.string(), source.title.line, 1, "the title is left out: " + why);
}

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
    if (!protocol::is_title(source.title.text)) warnings.push_back(title_left_out(source));
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
