#include "common/sources/source_reader.h"

#include <algorithm>
#include <utility>

#include "common/files.h"
#include "common/memory.h"
#include "common/sources/content.h"
#include "common/sources/resample.h"

namespace aucast::sources {
namespace {

/// The most bytes that a keyframe of a few AUs takes while a stream file is read: three times its
/// struct of 56 bytes when the list of them has just doubled, and the smallest block of memory for
/// its AUs.
constexpr std::uint64_t kReadKeyframeBytes = 200;
/// What the AUs of a long line take beyond that, for each byte of its text: two bytes at least name
/// an AU of three bytes, and lists have up to twice the room that they need.
constexpr std::uint64_t kReadByteBytes = 3;

}  // namespace

std::uint64_t lines_of(std::string_view text) {
  return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
}

Result<void> check_room(std::string_view text, const std::filesystem::path& path) {
  const std::uint64_t bytes =
      content_kind(text) == ContentKind::StreamFile
          ? lines_of(text) * kReadKeyframeBytes + text.size() * kReadByteBytes
          : lines_of(text) * kWholeKeyframeBytes;
  return check_memory(name_of(path), bytes, "choose a shorter stream");
}

Result<SourceContent> read_source(const std::filesystem::path& path, const ReadOptions& options) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return parse_source(*text, path, options);
}

Result<SourceContent> parse_source(std::string_view text, const std::filesystem::path& path,
                                   const ReadOptions& options) {
  RecordingOptions of_one = options.recording;
  of_one.all_faces = false;
  if (auto fits = check_room(text, path); !fits) return fits.error();
  auto streams = parse_streams(text, name_of(path), of_one, options.conditioning);
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
