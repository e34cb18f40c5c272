#include "client/app/stream_files.h"

#include "common/files.h"
#include "common/log.h"
#include "common/sources/found_report.h"
#include "common/sources/source_reader.h"
#include "common/text.h"
#include "protocol/stream_file.h"

namespace aucast::app {
namespace {

std::vector<playback::Keyframe> keyframes_of(const protocol::StreamFile& stream) {
  std::vector<playback::Keyframe> keyframes;
  keyframes.reserve(stream.keyframes.size());
  for (const protocol::Keyframe& keyframe : stream.keyframes) {
    playback::Keyframe timed{frame_from_terms(keyframe.terms), std::nullopt};
    if (keyframe.time_ms) timed.time = Milliseconds(*keyframe.time_ms);
    keyframes.push_back(timed);
  }
  return keyframes;
}

sources::ReadOptions read_options(const gui::TableSettings& settings,
                                  const sources::SettingNames& names) {
  sources::ReadOptions options;
  options.recording.names = names;
  if (settings.fps > 0) options.recording.fps = settings.fps;
  if (settings.rate > 0) options.rate = settings.rate;
  if (settings.gain_percent > 0) {
    options.conditioning.profile.gain.set_all(settings.gain_percent / 100.0);
  }
  if (settings.neutral_s > 0) options.conditioning.neutral_seconds = settings.neutral_s;
  return options;
}

std::string sentence(const sources::Found& found) {
  std::string text = found.format + ": " + counted(found.rows, "row");
  if (found.lost > 0) text += ", " + std::to_string(found.lost) + " without a face";
  if (found.left_out > 0) {
    text += ", " + std::to_string(found.left_out) + " left out (no later time)";
  }
  if (found.faces.size() > 1) text += "; one of " + std::to_string(found.faces.size()) + " faces";
  return text;
}

}  // namespace

Result<TitledStream> read_stream(const std::filesystem::path& file) {
  auto text = read_file(file);
  if (!text) return text.error();
  auto stream = protocol::parse_stream_file(*text, file.string());
  if (!stream) return stream.error();
  return TitledStream{keyframes_of(*stream), stream->title};
}

Result<OpenedStream> open_stream(const std::filesystem::path& file,
                                 const gui::TableSettings& settings,
                                 const sources::SettingNames& names) {
  auto content = sources::read_source(file, read_options(settings, names));
  if (!content) return content.error();
  OpenedStream opened{keyframes_of(content->stream), {}, {}};
  if (content->found) {
    opened.found = sentence(*content->found);
    opened.warnings = sources::warnings(*content->found, names);
  }
  return opened;
}

Result<std::vector<playback::Keyframe>> open_typed_stream(const std::filesystem::path& file,
                                                          const gui::TableSettings& settings) {
  auto opened = open_stream(file, settings, kOptionNames);
  if (!opened) return opened.error();
  if (!opened->found.empty()) spdlog::info("{}", opened->found);
  for (const std::string& warning : opened->warnings) spdlog::warn("{}", warning);
  if (opened->found.empty() && settings != gui::TableSettings{}) {
    spdlog::warn("{}", at_place(file.string(),
                                "a stream file, not changed by " + std::string(kOptionNames.fps) +
                                    ", --table-gain and " + std::string(kOptionNames.neutral)));
  }
  return std::move(opened->keyframes);
}

}  // namespace aucast::app
