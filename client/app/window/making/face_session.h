#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/gui/gui_model.h"
#include "common/result.h"

namespace aucast::app {

/// The faces to choose from, and the one of the assets, which can become another one. The assets
/// must outlive it. Thread: the player's.
class FaceSession {
 public:
  explicit FaceSession(Assets& assets);

  /// The window began with this face because it remembered it; empty: with the usual one.
  void remember(std::string face) { next_ = std::move(face); }
  /// What it should remember: a name of a shipped face, or a folder.
  [[nodiscard]] const std::string& next() const { return next_; }

  /// Reads a face into the place of the one of the assets and returns the names of the channels
  /// that the one before had: whatever was made of that one is to be made anew. After an error it
  /// is there as it was.
  [[nodiscard]] Result<std::vector<std::string>> show(const std::filesystem::path& folder);
  /// Shows which faces there are in this folder too.
  void look_in(const std::filesystem::path& folder);

  [[nodiscard]] const gui::FacesView& view() const { return view_; }
  /// How often the face has become another one.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

 private:
  void shown_from(const std::filesystem::path& folder);
  void list();

  Assets& assets_;
  std::filesystem::path looked_in_;  ///< beside the shipped and the own ones; empty: nowhere
  std::string next_;
  gui::FacesView view_;
  std::uint64_t changes_ = 0;
};

}  // namespace aucast::app
