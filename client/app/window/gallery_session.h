#pragma once

#include <functional>

#include "client/app/player_options.h"
#include "client/app/window/background_work.h"
#include "client/gui/gallery_view.h"

namespace aucast::app {

/// The gallery that the window makes in the background. Thread: the player's.
class GallerySession {
 public:
  /// Makes a gallery as the command does (make_gallery()), on another thread.
  using Make =
      std::function<Result<std::string>(const PlayerOptions& options, BackgroundWork::Course&)>;
  explicit GallerySession(Make make) : make_(std::move(make)) {}

  /// `shown`: options under which the command would draw the face as the window does.
  void apply(const gui::GalleryCommand& command, const PlayerOptions& shown);
  /// The pictures go to this folder.
  void set_folder(const std::filesystem::path& folder) { view_.settings.folder = folder.string(); }
  /// Takes over how far it is.
  void advance();
  [[nodiscard]] const gui::GalleryView& view() const { return view_; }

 private:
  void begin(PlayerOptions options);

  Make make_;
  gui::GalleryView view_;
  BackgroundWork work_;
};

}  // namespace aucast::app
