#pragma once

#include <filesystem>
#include <string>

#include "client/gui/model/browser_view.h"

namespace aucast::gui {

/// Whether this file is a face.toml, by which the face in its folder is chosen.
[[nodiscard]] bool is_face_file(const std::filesystem::path& file);

/// A file dialog without its widgets: goes through folders and says which file was chosen.
class FileBrowser {
 public:
  /// Opens the dialog at `folder`, or at the nearest existing one above it.
  void open(Purpose purpose, const std::filesystem::path& folder, std::string name = {});
  void close() { view_ = {}; }
  /// Goes to a folder; a relative path starts at the one shown. If the folder cannot be read, stays
  /// and says why.
  void enter(const std::filesystem::path& folder);
  /// Returns true and sets `chosen` if `file` is what the user wants. Returns false if it is a
  /// folder, which is entered. Also returns false if a new file would replace an existing one: the
  /// user is asked, and choosing it again means yes. A new file gets the ending of its kind if it
  /// has none. Where a folder is wanted, "." means the folder shown, and the name of a file means
  /// its folder.
  [[nodiscard]] bool choose(const std::filesystem::path& file, std::filesystem::path& chosen);
  /// Call it if the chosen file could not be used: the dialog stays open and says so.
  void refuse(std::string problem);
  /// Stops saying what was wrong, because the user has changed something.
  void forget_problem() { view_.problem.clear(); }
  [[nodiscard]] const BrowserView& view() const { return view_; }

 private:
  BrowserView view_;
};

}  // namespace aucast::gui
