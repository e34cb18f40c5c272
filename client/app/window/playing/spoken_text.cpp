#include "client/app/window/playing/spoken_text.h"

#include <algorithm>
#include <utility>

#include "common/files.h"
#include "common/log.h"
#include "common/sound_name.h"
#include "common/text.h"
#include "common/voice/webvtt.h"
#include "protocol/stream_file.h"

namespace aucast::app {

Result<void> SpokenText::read_beside(const std::filesystem::path& file) {
  if (const auto text = read_file(file)) {
    protocol::StreamTitle title = protocol::stream_title(*text);
    if (const std::string wrong = protocol::title_complaint(title, file.string()); wrong.empty()) {
      title_ = std::move(title.text);
    } else {
      spdlog::warn("{}", wrong);
    }
  }
  const auto captions = file_beside(file, ".vtt");
  if (!captions) return {};
  const auto text = read_file(*captions);
  if (!text) return text.error();
  auto read = voice::parse_webvtt(*text, printable(captions->string()));
  if (!read) return read.error();
  all_ = std::move(*read);
  return {};
}

void SpokenText::move_to(playback::Playback& playback, Duration place) {
  line_.take_from(playback);
  if (playback.seekable() == nullptr) {
    title_ = playback.status().title;
    line_.move_to(place);
    caption_ = line_.text();
    return;
  }
  const auto next = std::upper_bound(all_.begin(), all_.end(), place,
                                     [](Duration at, const protocol::CaptionData& caption) {
                                       return at < Milliseconds(caption.place_ms);
                                     });
  caption_ = next == all_.begin() ? std::string() : std::prev(next)->text;
}

}  // namespace aucast::app
