#include "common/sources/source_reader.h"

#include <utility>

#include "common/files.h"
#include "common/sources/content.h"
#include "common/sources/resample.h"

namespace aucast::sources {

Result<SourceContent> read_source(const std::filesystem::path& path, const ReadOptions& options) {
  RecordingOptions of_one = options.recording;
  of_one.all_faces = false;
  const auto text = read_text(path);
  if (!text) return text.error();
  auto streams = parse_streams(*text, name_of(path), of_one, options.conditioning);
  if (!streams) return streams.error();
  SourceContent& content = streams->front();
  if (options.rate) content.stream = resample(content.stream, *options.rate, options.keyframe_ms);
  return std::move(content);
}

Result<std::string> read_text(const std::filesystem::path& path, const std::stop_token& stop) {
  return path == "-" ? read_standard_input() : read_file(path, kWholeFileBytesMax, stop);
}

std::string name_of(const std::filesystem::path& path) {
  return path == "-" ? "stdin" : path.string();
}

Result<std::vector<SourceContent>> parse_streams(std::string_view text, const std::string& file,
                                                 const RecordingOptions& recording,
                                                 const ConditioningSettings& conditioning,
                                                 const std::stop_token& stop) {
  std::vector<SourceContent> contents;
  if (content_kind(text) == ContentKind::StreamFile) {
    auto stream = protocol::parse_stream_file(text, file, stop);
    if (!stream) return stream.error();
    contents.push_back({std::move(*stream), std::nullopt});
    return contents;
  }
  auto faces = read_faces(text, file, recording, conditioning, load_arkit_table, stop);
  if (!faces) return faces.error();
  for (Recording& one : *faces) {
    contents.push_back({std::move(one.stream), std::move(one.found)});
  }
  return contents;
}

}  // namespace aucast::sources
