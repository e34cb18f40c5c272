#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "client/app/background_work.h"
#include "client/app/player_options.h"
#include "client/gui/model/gallery_view.h"
#include "common/time.h"

namespace aucast::app {

/// Makes a gallery in the background, for the window. Thread: the player's.
class GallerySession {
 public:
  /// Makes a gallery as the command does (make_gallery()); called on another thread.
  using Make =
      std::function<Result<std::string>(const PlayerOptions& options, BackgroundWork::Course&)>;
  /// Returns how many pictures a gallery has (gallery_size()).
  using Count = std::function<Result<std::size_t>(const PlayerOptions& options)>;
  GallerySession(Make make, Count count) : make_(std::move(make)), count_(std::move(count)) {}

  /// `shown`: the options with which `face-player gallery` would draw the face as the window does.
  void apply(const gui::GalleryCommand& command, const PlayerOptions& shown);
  /// Sets the folder for the pictures.
  void set_folder(const std::filesystem::path& folder) { view_.settings.folder = folder.string(); }
  /// Updates view() with how far the work is at `now`.
  void advance(Instant now);
  /// Waits until the gallery that is being made has ended; advance() then updates view().
  void wait() const { work_.wait(); }
  [[nodiscard]] const gui::GalleryView& view() const { return view_; }

 private:
  [[nodiscard]] PlayerOptions options_under(PlayerOptions shown) const;
  void plan(const PlayerOptions& shown);
  void begin(const PlayerOptions& shown);
  void estimate(Instant now);

  Make make_;
  Count count_;
  gui::GalleryView view_;
  BackgroundWork work_;
  std::optional<Instant> first_at_;  ///< when the first picture was ready; the pace is measured
                                     ///< from then on
  std::size_t first_ = 0;            ///< how many pictures were ready at first_at_
};

}  // namespace aucast::app
