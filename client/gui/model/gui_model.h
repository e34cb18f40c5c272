#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/gui/model/browser_view.h"
#include "client/gui/model/composer_view.h"
#include "client/gui/model/display_settings.h"
#include "client/gui/model/editor_view.h"
#include "client/gui/model/face_names.h"
#include "client/gui/model/gallery_view.h"
#include "client/gui/model/mirror_view.h"
#include "client/gui/model/picture_settings.h"
#include "client/gui/model/remote_settings.h"
#include "client/gui/model/rendering_view.h"
#include "client/gui/model/sound_view.h"
#include "client/gui/model/stream_view.h"
#include "client/gui/model/table_settings.h"

namespace aucast::gui {

/// A sentence about what was just done, such as where a file was saved.
struct Notice {
  std::string text;  ///< empty: no notice
  bool bad = false;
  friend bool operator==(const Notice&, const Notice&) = default;
};

/// The files of videos that are being made.
struct VideoView {
  std::string recording;   ///< the one being recorded; empty: none
  std::string completing;  ///< the one recorded before, whose file is being completed; empty: none
  friend bool operator==(const VideoView&, const VideoView&) = default;
};

/// A file for other programs that is being written in the background.
struct ExportView {
  std::string file;     ///< empty: none
  int percent = 0;      ///< how much of the movement has been written
  bool ending = false;  ///< the writing was cancelled, but has not ended yet
  friend bool operator==(const ExportView&, const ExportView&) = default;
};

/// What the panels show, as plain data that is made anew for every frame. A panel is a function
/// from this to the commands of gui_commands.h; it keeps only the state of its widgets.
struct GuiModel {
  RemoteSettings remote_settings;   ///< those in use; the form begins with them
  std::vector<std::string> recent;  ///< addresses that answered, the newest first
  StreamsView streams;
  PlayingView playing;
  LocalView local;
  MirrorView mirror;
  SoundView sound;
  SpokenView spoken;
  TablesView tables;
  std::string sample;                     ///< a stream file for demonstration; empty: none
  std::vector<std::string> recent_files;  ///< the newest first
  FacesView faces;
  GalleryView gallery;
  PictureSettings pictures;
  std::string picture_folder;  ///< the full path of the folder in `pictures`
  BrowserView browser;
  CredentialFiles credentials;
  Notice notice;
  AnimationSettings animation;
  EditorView editor;
  ComposerView composer;
  std::shared_ptr<const std::vector<AuEntry>> known_aus;  ///< never null
  VideoView video;
  ExportView exported;
  std::string onsets;  ///< the file for the times at which faces are shown; empty: none
  ExpressionsView expressions;
  TransitionSettings transition;
  RenderingView rendering;
  DisplayView display;
  bool asks_to_leave = false;  ///< the user wants to leave, but something would be lost
  friend bool operator==(const GuiModel&, const GuiModel&) = default;
};

}  // namespace aucast::gui
