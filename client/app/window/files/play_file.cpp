#include "client/app/window/files/play_file.h"

#include <string>
#include <utility>

#include "client/app/stream_files.h"
#include "client/gui/model/view_text.h"
#include "client/gui/texts/said_text.h"
#include "client/gui/texts/texts.h"
#include "common/film_name.h"
#include "common/sound_name.h"

namespace aucast::app {
namespace {

Result<bool> play_sound(const std::filesystem::path& file, PlaybackSession& playback, Instant now) {
  const gui::LocalView local = playback.local_view();
  if (!local.open) {
    return Error{ErrorKind::Usage, gui::tr("said.sound_alone", file.filename().string())};
  }
  if (auto heard = playback.sound().play_file(file, local.name, now); !heard) return heard.error();
  return false;
}

}  // namespace

Result<bool> play_file(const std::filesystem::path& file, FileSession& files,
                       PlaybackSession& playback, Notices& notices, Instant now) {
  if (is_film(file)) {
    return Error{ErrorKind::Usage, gui::tr("said.is_film", file.filename().string())};
  }
  if (is_sound(file)) return play_sound(file, playback, now);
  const gui::KnownTable table = files.table_of(file);
  auto opened = open_stream(file, table.settings, kDialogNames);
  if (!opened) return opened.error();
  files.opened(file);
  playback.open(std::move(opened->keyframes), file.filename().string(), now);
  if (!opened->found.empty()) {
    files.remember(table);
    std::string text = gui::in_used_language(opened->found);
    const std::string changed = gui::table_in_words(table.settings);
    if (!changed.empty()) text += "\n" + gui::tr("file.tables_applied", changed);
    for (const std::string& one : opened->warnings) text += "\n" + gui::in_used_language(one);
    notices.say(text, !opened->warnings.empty(), now);
  }
  playback.play_beside(file, now);
  return true;
}

}  // namespace aucast::app
