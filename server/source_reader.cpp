#include "server/source_reader.h"

#include <string>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "server/sources/arkit_table.h"
#include "server/sources/resample.h"

namespace aucast::server {
namespace {

Result<SourceContent> read_table(std::string_view text, const std::string& file,
                                 const SourceOptions& options, sources::ContentKind kind) {
  sources::ArkitTable curves;
  if (kind == sources::ContentKind::LiveLinkFace) {
    auto table = load_arkit_table();
    if (!table) return table.error();
    curves = std::move(*table);
  }
  auto recording = sources::read_recording(text, file, options.recording, curves);
  if (!recording) return recording.error();
  return SourceContent{std::move(recording->stream), std::move(recording->found)};
}

Result<SourceContent> read_content(std::string_view text, const std::string& file,
                                   const SourceOptions& options) {
  const sources::ContentKind kind = sources::content_kind(text);
  if (kind != sources::ContentKind::StreamFile) return read_table(text, file, options, kind);
  auto stream = protocol::parse_stream_file(text, file);
  if (!stream) return stream.error();
  return SourceContent{std::move(*stream), std::nullopt};
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
                                  std::uint32_t keyframe_ms) {
  const auto text = read_file(path == "-" ? "/dev/stdin" : path);
  if (!text) return text.error();
  auto content = read_content(*text, path == "-" ? "stdin" : path.string(), options);
  if (content && options.rate) {
    content->stream = sources::resample(content->stream, *options.rate, keyframe_ms);
  }
  return content;
}

}  // namespace aucast::server
