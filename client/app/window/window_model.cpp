#include "client/app/window/window_model.h"

#include <filesystem>

#include "common/files.h"

namespace aucast::app {
namespace {

gui::PlayingView playing(const WindowSession& session) {
  gui::PlayingView view = session.playback().playing_view();
  const ShownFace& face = session.face();
  if (face.is(Shown::Playback)) return view;
  view.stale = view.eased = false;
  view.aus = face.is(Shown::Editor) ? session.editor().au_rows() : session.composer().au_rows();
  return view;
}

}  // namespace

gui::GuiModel model_of(const WindowSession& session) {
  const PlaybackSession& playback = session.playback();
  const EditorSession& editor = session.editor();
  const FileSession& files = session.files();
  const SettingsSession& settings = session.settings();
  const ShownFace& face = session.face();
  gui::GuiModel model;
  model.remote_settings = playback.servers().settings();
  model.recent = playback.servers().recent();
  model.streams = session.lister().view();
  model.playing = playing(session);
  model.local = playback.local_view();
  model.mirror = session.mirror().view();
  model.mirror.wanted = session.options().shows_mirror;
  model.sound = playback.sound().sound_view();
  model.spoken = playback.sound().spoken_view();
  model.tables = files.tables();
  model.sample = files.sample();
  model.recent_files = files.recent();
  model.faces = session.faces().view();
  model.gallery = session.gallery().view();
  model.pictures = settings.pictures();
  model.picture_folder = whole_path(std::filesystem::path(".") / model.pictures.folder).string();
  model.display = settings.display();
  model.browser = files.view();
  model.credentials = files.credentials();
  model.notice = session.notices().view();
  model.animation = settings.animation();
  model.editor = editor.view(face.is(Shown::Editor));
  model.composer = session.composer().view(face.is(Shown::Composer));
  model.composer.can_take = !face.is(Shown::Composer) && face.aus().has_value();
  model.known_aus = editor.known_aus();
  model.exported = session.exports().view();
  model.onsets = session.onsets().file().string();
  model.expressions = editor.expressions();
  model.transition = editor.transition();
  model.rendering.settings = settings.rendering();
  model.asks_to_leave = session.leaving().asks();
  return model;
}

}  // namespace aucast::app
