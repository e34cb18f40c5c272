#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/app/background_work.h"
#include "client/app/player_options.h"
#include "client/app/window/playing/played.h"
#include "client/face/face.h"
#include "client/gui/gui_model.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"

namespace aucast::app {

/// Files of what the window shows and plays, for other programs. Each sentence says where one went,
/// and that it is not all if it is not.
/// Thread: the player's.
class ExportSession {
 public:
  /// Writes a GLB file (film/glb_export.h), on another thread.
  using MakeGlb = std::function<Result<std::string>(
      const PlayerOptions& options, const std::vector<playback::Keyframe>& keyframes,
      const std::string& name, BackgroundWork::Course& course)>;
  explicit ExportSession(MakeGlb make) : make_(std::move(make)) {}

  /// What was played as a stream file (save_stream()). Failed without a keyframe.
  [[nodiscard]] static Result<std::string> stream(const Played& played,
                                                  const std::filesystem::path& file);
  /// Its AUs as a table (au_table.h). Failed without a keyframe.
  [[nodiscard]] static Result<std::string> table(const Played& played,
                                                 const std::filesystem::path& file);
  /// The skin of a face with these activations, as Wavefront OBJ.
  [[nodiscard]] static Result<std::string> mesh(const face::Face& face,
                                                std::span<const float> activations,
                                                const std::filesystem::path& file);
  /// The face of the options, and what was played as its animation, if there is any, begins to be
  /// written. Failed while another one is.
  [[nodiscard]] Result<std::string> glb(PlayerOptions options, Played played,
                                        const std::string& name, const std::filesystem::path& file);
  /// The GLB file is not wanted any more.
  void cancel() { work_.cancel(); }
  /// What became of the GLB file, once.
  [[nodiscard]] std::optional<Result<std::string>> advance();
  [[nodiscard]] gui::ExportView view() const;

 private:
  MakeGlb make_;
  std::string file_;  ///< of the GLB file that is or was written
  BackgroundWork work_;
};

}  // namespace aucast::app
