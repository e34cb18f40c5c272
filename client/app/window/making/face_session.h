#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/window/making/shipped_copies.h"
#include "client/gui/model/gui_model.h"
#include "common/result.h"

namespace aucast::app {

/// The faces to choose from, and the one in the assets, which can be replaced. The assets must
/// outlive it. Thread: the player's.
class FaceSession {
 public:
  explicit FaceSession(Assets& assets);

  /// Call it with the remembered face that the window was started with; empty: the default one.
  void remember(std::string face) { next_ = std::move(face); }
  /// The face that the window should remember: the name of a shipped one, or a folder.
  [[nodiscard]] const std::string& next() const { return next_; }

  /// Replaces the face in the assets by the one in this folder. Everything made from the previous
  /// face must then be made anew. Returns the names of the previous face's channels. After an error
  /// the previous face is still there.
  [[nodiscard]] Result<std::vector<std::string>> show(const std::filesystem::path& folder);
  /// Adds the faces in this folder to the list.
  void look_in(const std::filesystem::path& folder);

  // These change the list of faces, not the face that is shown.

  /// Copies the face in `folder` to a new one of the user's own; returns its folder.
  [[nodiscard]] Result<std::filesystem::path> copy(const std::filesystem::path& folder,
                                                   const std::string& name);
  /// Renames a face of the user's own; returns its new folder.
  [[nodiscard]] Result<std::filesystem::path> rename(const std::filesystem::path& folder,
                                                     const std::string& name);
  /// Deletes a face of the user's own.
  [[nodiscard]] Result<void> remove(const std::filesystem::path& folder);
  /// The shipped face from which a face of the user's own was copied, or the default one if it was
  /// not copied from a shipped face. Fails if `folder` is not a face of the user's own.
  [[nodiscard]] Result<std::filesystem::path> origin(const std::filesystem::path& folder) const;

  [[nodiscard]] const gui::FacesView& view() const { return view_; }
  /// How often the face has been replaced.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

 private:
  void shown_from(const std::filesystem::path& folder);
  void list();
  [[nodiscard]] Result<void> check_own(const std::filesystem::path& folder) const;
  [[nodiscard]] Result<void> check_name(const std::string& name) const;

  Assets& assets_;
  ShippedCopies copies_;
  std::filesystem::path looked_in_;  ///< where faces are looked for besides the shipped and the
                                     ///< user's own; empty: nowhere
  std::string next_;
  gui::FacesView view_;
  std::uint64_t changes_ = 0;
};

}  // namespace aucast::app
