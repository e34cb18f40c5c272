#include "client/app/stream_files.h"

#include <algorithm>

#include "common/files.h"
#include "common/log.h"
#include "common/memory.h"
#include "common/sources/content.h"
#include "common/sources/found_report.h"
#include "common/sources/source_reader.h"
#include "common/text.h"
#include "protocol/stream_file.h"

namespace aucast::app {
namespace {

/// The most bytes that a keyframe takes while it is played: 16 in the list, 32 for when it is
/// reached, and in the window 4 in the curve of each AU, of which a recogniser has some 20.
constexpr std::uint64_t kPlayedKeyframeBytes = 128;
/// The same for an AU of it: three times 8 bytes when the list of them has just doubled.
constexpr std::uint64_t kPlayedAuBytes = 24;
/// The most bytes that a keyframe takes in the composer, which has each with all AUs, and its row.
/// Steps to undo take no more than gui::Composer::kUndoBytesMax besides.
constexpr std::uint64_t kEditedKeyframeBytes = 1000;
constexpr std::string_view kShorter = "choose a shorter stream";

void add(const protocol::Keyframe& keyframe, playback::KeyframeList& keyframes) {
  std::optional<Milliseconds> time;
  if (keyframe.time_ms) time = Milliseconds(*keyframe.time_ms);
  keyframes.add(frame_from_terms(keyframe.terms), time);
}

playback::KeyframeList keyframes_of(const protocol::StreamFile& stream) {
  playback::KeyframeList keyframes;
  keyframes.reserve(stream.keyframes.size());
  for (const protocol::Keyframe& keyframe : stream.keyframes) add(keyframe, keyframes);
  return keyframes;
}

/// Reads the text of a stream file keyframe by keyframe, so that each is in memory only once.
Result<playback::KeyframeList> read_keyframes(std::string_view text, const std::string& file) {
  const std::uint64_t lines = sources::lines_of(text);
  const auto commas = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), ','));
  const std::uint64_t bytes = lines * kPlayedKeyframeBytes + (lines + commas) * kPlayedAuBytes;
  if (auto fits = check_memory(file, bytes, kShorter); !fits) return fits.error();
  playback::KeyframeList keyframes;
  keyframes.reserve(lines);
  const auto take = [&keyframes](const protocol::Keyframe& keyframe) -> Result<void> {
    add(keyframe, keyframes);
    return {};
  };
  if (auto read = protocol::read_stream_file(text, file, take); !read) return read.error();
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
  auto fits = check_memory(file, sources::lines_of(*text) * kEditedKeyframeBytes, kShorter);
  if (!fits) return fits.error();
  auto keyframes = read_keyframes(*text, file.string());
  if (!keyframes) return keyframes.error();
  return TitledStream{*std::move(keyframes), protocol::stream_title(*text).text};
}

Result<OpenedStream> open_stream(const std::filesystem::path& file,
                                 const gui::TableSettings& settings,
                                 const sources::SettingNames& names) {
  const auto text = sources::read_text(file);
  if (!text) return text.error();
  const sources::ReadOptions options = read_options(settings, names);
  if (!options.rate && sources::content_kind(*text) == sources::ContentKind::StreamFile) {
    auto keyframes = read_keyframes(*text, sources::name_of(file));
    if (!keyframes) return keyframes.error();
    return OpenedStream{*std::move(keyframes), {}, {}};
  }
  auto content = sources::parse_source(*text, file, options);
  if (!content) return content.error();
  OpenedStream opened{keyframes_of(content->stream), {}, {}};
  if (content->found) {
    opened.found = sentence(*content->found);
    opened.warnings = sources::warnings(*content->found, names);
  }
  return opened;
}

Result<playback::KeyframeList> open_typed_stream(const std::filesystem::path& file,
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
