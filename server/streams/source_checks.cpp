#include "server/streams/source_checks.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <utility>

#include "common/options.h"
#include "common/text.h"
#include "server/streams/source_path.h"

namespace aucast::server {
namespace {

/// Checks that there is a source that --record can record.
Result<void> check_record(const TransmitterOptions& options) {
  if (options.record.empty()) return {};
  const bool any_live = std::any_of(options.sources.begin(), options.sources.end(),
                                    [&options](const std::filesystem::path& path) {
                                      return is_live(path, options.live_source.follow);
                                    });
  if (any_live) return {};
  return usage_error(
      "--record keeps what is still being written (-, a FIFO, a file with --follow), and no SOURCE "
      "is; 'au-transmitter convert' writes a recording as a stream file");
}

/// Checks that --preview can show the sources.
Result<void> check_preview(const TransmitterOptions& options) {
  if (!options.preview) return {};
  if (options.sources.size() != 1 || !camera_device(options.sources.front())) {
    return usage_error("--preview shows what a camera sees: let that be the only SOURCE");
  }
  // Also out of the environment of whoever started us.
  const std::array<std::pair<bool, const char*>, 5> public_options{
      {{!options.push.addresses.empty(), "--push"},
       {!options.engine.publish.empty(), "--publish"},
       {options.web.address.has_value(), "--web"},
       {!options.credentials.publishers.empty(), "--accept-push"},
       {!options.record.empty(), "--record"}}};
  for (const auto& [given, name] : public_options) {
    if (given) return usage_error(std::string("--preview is for oneself; it goes without ") + name);
  }
  return {};
}

/// Checks that --voice can be the voice of these sources.
Result<void> check_voice(const TransmitterOptions& options) {
  const VoiceOptions& voice = options.voice;
  if (voice.none || voice.file.empty()) return {};
  const bool serving = !options.check && !options.estimate;
  const bool live_face = serving && is_live(options.sources.front(), options.live_source.follow);
  const bool live_sound = is_live(voice.file, false);
  const std::string name = "--voice " + escaped(voice.file.string());
  if (voice.file == "-" && std::count(options.sources.begin(), options.sources.end(), "-") > 0) {
    return usage_error("--voice - and SOURCE - would both read stdin; use a FIFO");
  }
  if (live_sound && !live_face) {
    return usage_error(name +
                       " is still being written, and so must be the face: the first SOURCE is not "
                       "-, a FIFO or, with --follow, a file");
  }
  if (live_face && !live_sound) {
    return usage_error(name + " beside a live SOURCE must be - or a FIFO");
  }
  return {};
}

}  // namespace

Result<void> check_sources(const TransmitterOptions& options) {
  if (auto can = check_preview(options); !can) return can;
  if (auto can = check_voice(options); !can) return can;
  if (options.check || options.estimate) return {};
  return check_record(options);
}

}  // namespace aucast::server
