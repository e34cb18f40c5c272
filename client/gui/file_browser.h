#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aucast::gui {

/// What a file is wanted for.
enum class Purpose : std::uint8_t {
  PlayStream,       ///< a stream file or a table to be played, or a face to be shown
  ComposeStream,    ///< a stream file to be worked on
  SaveStream,       ///< where what was composed goes
  ExportKeyframes,  ///< where what was played goes
  ExportTable,      ///< where the AUs of what was played go
  ExportMesh,       ///< where the mesh of the face that is shown goes
  ExportGlb,        ///< where face and movement go
  LogOnsets,        ///< where the times at which faces are shown go
  ExportAu,         ///< where an AU goes
  ImportAus,        ///< a file of AUs to be imported
  PictureFolder,    ///< where pictures and videos go
  GalleryFolder,    ///< where a gallery goes
  LookForFaces,     ///< a folder of faces, or the folder of one face
  CameraFilm,       ///< a film in place of a camera
};

struct FileEntry {
  std::string name;
  bool folder = false;
  friend bool operator==(const FileEntry&, const FileEntry&) = default;
};

/// The file dialog: a folder and what is in it.
struct BrowserView {
  bool open = false;
  Purpose purpose = Purpose::PlayStream;
  std::string folder;
  std::vector<FileEntry> entries;
  std::string name;      ///< the name for a new file
  std::string problem;   ///< why the folder cannot be shown or the file not be used; empty: it can
  std::string replaces;  ///< an existing file about which the user is asked; empty: none
  friend bool operator==(const BrowserView&, const BrowserView&) = default;
};

/// Whether this is the file by which a face is chosen; it stands for its folder.
[[nodiscard]] bool is_face_file(const std::filesystem::path& file);

[[nodiscard]] bool is_saving(Purpose purpose);
/// Whether a folder is wanted rather than a file.
[[nodiscard]] bool is_folder(Purpose purpose);

/// A file dialog without its widgets: goes through folders and says which file was chosen.
class FileBrowser {
 public:
  /// Opens the dialog at `folder`, or at the nearest existing one above it.
  void open(Purpose purpose, const std::filesystem::path& folder, std::string name = {});
  void close() { view_ = {}; }
  /// Goes to a folder; a relative path starts at the one shown. If it cannot be read, stays and
  /// says why.
  void enter(const std::filesystem::path& folder);
  /// Returns true and sets `chosen` if `file` is what the user wants. Returns false if it is a
  /// folder, which is entered, or if a new file would replace an existing one: the user is asked,
  /// and choosing it again means yes. Where a folder is wanted, "." is the one shown, and the name
  /// of a file means its folder.
  [[nodiscard]] bool choose(const std::filesystem::path& file, std::filesystem::path& chosen);
  /// Call it if the chosen file could not be used: the dialog stays open and says so.
  void refuse(std::string problem);
  [[nodiscard]] const BrowserView& view() const { return view_; }

 private:
  BrowserView view_;
};

}  // namespace aucast::gui
