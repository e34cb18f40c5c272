#include "client/app/window/making/composition_file.h"

#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "client/gui/texts/texts.h"
#include "common/files.h"
#include "protocol/limits.h"
#include "protocol/stream_file.h"

namespace aucast::app {

static_assert(gui::Composer::kMsMax == protocol::kKeyframeTimeMsMax);

gui::ComposedKeyframe composed(const playback::Keyframe& keyframe) {
  gui::ComposedKeyframe composed{keyframe.aus, std::nullopt};
  if (keyframe.time) composed.ms = static_cast<std::uint32_t>(keyframe.time->count());
  return composed;
}

Result<std::string> stream_text(const gui::Composer::Keyframes& keyframes,
                                const std::string& title) {
  if (keyframes.empty()) {
    return Error{ErrorKind::Failed, gui::tr("said.nothing_to_save")};
  }
  protocol::StreamFile stream;
  stream.title = title;
  for (const auto& keyframe : keyframes) {
    protocol::Keyframe packet;
    packet.terms = canonical_terms(keyframe->aus);
    packet.time_ms = keyframe->ms;
    stream.keyframes.push_back(std::move(packet));
  }
  std::string text = protocol::format_stream_file(stream);
  // What cannot be read again must never replace a file.
  if (auto read = protocol::parse_stream_file(text, "the composed stream"); !read) {
    return read.error();
  }
  return text;
}

Result<std::string> save_stream(const gui::Composer::Keyframes& keyframes,
                                const std::filesystem::path& file, const std::string& title) {
  const auto text = stream_text(keyframes, title);
  if (!text) return text.error();
  std::string kept;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    const auto before = read_file(file);
    if (!before) return before.error();
    if (*before != *text) {
      const auto written = write_file_atomically(file.string() + "~", *before);
      if (!written) return written.error();
      kept = file.filename().string() + "~";
    }
  }
  if (const auto written = write_file_atomically(file, *text); !written) return written.error();
  if (kept.empty()) return gui::tr("said.saved", file.string());
  return gui::tr("said.saved_kept", file.string(), kept);
}

}  // namespace aucast::app
