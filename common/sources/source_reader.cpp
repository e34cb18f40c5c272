#include "common/sources/source_reader.h"

#include <string>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/sources/content.h"
#include "common/sources/resample.h"

namespace aucast::sources {
namespace {

Result<std::vector<SourceContent>> read_content(std::string_view text, const std::string& file,
                                                const ReadOptions& options) {
  std::vector<SourceContent> contents;
  if (content_kind(text) == ContentKind::StreamFile) {
    auto stream = protocol::parse_stream_file(text, file);
    if (!stream) return stream.error();
    contents.push_back({std::move(*stream), std::nullopt});
    return contents;
  }
  auto faces = read_faces(text, file, options.recording, options.conditioning);
  if (!faces) return faces.error();
  for (Recording& recording : *faces) {
    contents.push_back({std::move(recording.stream), std::move(recording.found)});
  }
  return contents;
}

}  // namespace

Result<SourceContent> read_source(const std::filesystem::path& path, const ReadOptions& options) {
  ReadOptions of_one = options;
  of_one.recording.all_faces = false;
  auto streams = read_streams(path, of_one);
  if (!streams) return streams.error();
  return std::move(streams->front());
}

Result<std::vector<SourceContent>> read_streams(const std::filesystem::path& path,
                                                const ReadOptions& options) {
  const auto text = path == "-" ? read_standard_input() : read_file(path);
  if (!text) return text.error();
  auto contents = read_content(*text, path == "-" ? "stdin" : path.string(), options);
  if (!contents || !options.rate) return contents;
  for (SourceContent& content : *contents) {
    content.stream = resample(content.stream, *options.rate, options.keyframe_ms);
  }
  return contents;
}

}  // namespace aucast::sources
