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
#include "client/gui/model/gui_model.h"
#include "client/playback/keyframe_list.h"
#include "common/result.h"

namespace aucast::app {

/// Writes what the window shows and plays to files for other programs. The sentences that are
/// returned say where a file was saved and, if the file is incomplete, what is missing.
/// Thread: the player's.
class ExportSession {
 public:
  /// Writes a GLB file (video/glb_export.h); called on another thread.
  using MakeGlb = std::function<Result<std::string>(
      const PlayerOptions& options, const playback::KeyframeList& keyframes,
      const std::string& name, BackgroundWork::Course& course)>;
  explicit ExportSession(MakeGlb make) : make_(std::move(make)) {}

  /// Writes what was played as a stream file (save_stream()). Fails if there is no keyframe.
  [[nodiscard]] static Result<std::string> stream(const Played& played,
                                                  const std::filesystem::path& file);
  /// Writes the AUs of what was played as a table (au_table.h). Fails if there is no keyframe.
  [[nodiscard]] static Result<std::string> table(const Played& played,
                                                 const std::filesystem::path& file);
  /// Writes the skin of a face with these activations as Wavefront OBJ.
  [[nodiscard]] static Result<std::string> mesh(const face::Face& face,
                                                std::span<const float> activations,
                                                const std::filesystem::path& file);
  /// Begins to write the face of the options as a GLB file, with what was played (if anything) as
  /// its animation. Fails while another GLB file is being written.
  [[nodiscard]] Result<std::string> glb(PlayerOptions options, Played played,
                                        const std::string& name, const std::filesystem::path& file);
  /// Cancels the writing of the GLB file.
  void cancel() { work_.cancel(); }
  /// Waits until the writing of the GLB file has ended.
  void wait() const { work_.wait(); }
  /// Returns the result once, after the writing of the GLB file has ended.
  [[nodiscard]] std::optional<Result<std::string>> advance();
  [[nodiscard]] gui::ExportView view() const;

 private:
  MakeGlb make_;
  std::string file_;  ///< the GLB file that is being written, or was written last
  BackgroundWork work_;
};

}  // namespace aucast::app
