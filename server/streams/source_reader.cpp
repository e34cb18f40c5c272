#include "server/streams/source_reader.h"

#include <string>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/sources/arkit_table.h"
#include "common/sources/resample.h"

namespace aucast::server {
namespace {

Result<std::vector<SourceContent>> read_table(std::string_view text, const std::string& file,
                                              const SourceOptions& options,
                                              const sources::ConditioningSettings& conditioning,
                                              sources::ContentKind kind) {
  sources::ArkitTable curves;
  if (kind == sources::ContentKind::LiveLinkFace) {
    auto table = load_arkit_table();
    if (!table) return table.error();
    curves = std::move(*table);
  }
  auto faces = sources::read_faces(text, file, options.recording, curves, conditioning);
  if (!faces) return faces.error();
  std::vector<SourceContent> contents;
  for (sources::Recording& recording : *faces) {
    contents.push_back({std::move(recording.stream), std::move(recording.found)});
  }
  return contents;
}

Result<std::vector<SourceContent>> read_content(std::string_view text, const std::string& file,
                                                const SourceOptions& options,
                                                const sources::ConditioningSettings& conditioning) {
  const sources::ContentKind kind = sources::content_kind(text);
  if (kind != sources::ContentKind::StreamFile) {
    return read_table(text, file, options, conditioning, kind);
  }
  auto stream = protocol::parse_stream_file(text, file);
  if (!stream) return stream.error();
  std::vector<SourceContent> contents;
  contents.push_back({std::move(*stream), std::nullopt});
  return contents;
}

}  // namespace

Result<sources::ArkitTable> load_arkit_table() {
  const auto data = find_data_folder({});
  if (!data) return data.error();
  const auto path = *data / "sources" / "arkit_to_au.csv";
  const auto text = read_file(path);
  if (!text) return text.error();
  return sources::parse_arkit_table(*text, path.string());
}

Result<SourceContent> read_source(const std::filesystem::path& path, const SourceOptions& options,
                                  const sources::ConditioningSettings& conditioning,
                                  std::uint32_t keyframe_ms) {
  SourceOptions of_one = options;
  of_one.recording.all_faces = false;
  auto streams = read_streams(path, of_one, conditioning, keyframe_ms);
  if (!streams) return streams.error();
  return std::move(streams->front());
}

Result<std::vector<SourceContent>> read_streams(const std::filesystem::path& path,
                                                const SourceOptions& options,
                                                const sources::ConditioningSettings& conditioning,
                                                std::uint32_t keyframe_ms) {
  const auto text = read_file(path == "-" ? "/dev/stdin" : path);
  if (!text) return text.error();
  auto contents = read_content(*text, path == "-" ? "stdin" : path.string(), options, conditioning);
  if (!contents || !options.rate) return contents;
  for (SourceContent& content : *contents) {
    content.stream = sources::resample(content.stream, *options.rate, keyframe_ms);
  }
  return contents;
}

}  // namespace aucast::server
