#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aucast::gui {

/// What a file is asked for.
enum class Purpose : std::uint8_t {
  PlayStream,       ///< a stream file or a table to be played, or a face to be shown
  ComposeStream,    ///< a stream file to be worked on
  SaveStream,       ///< where what was composed goes
  ExportKeyframes,  ///< where what was played goes
  ExportTable,      ///< where the AUs of what was played go
  ExportMesh,       ///< where the mesh of the face that is shown goes
  ExportGlb,        ///< where face and movement go
  LogOnsets,        ///< where the times go at which faces are shown
  ExportAu,         ///< where an AU goes
  ImportAus,        ///< a file of AUs to be taken over
  PictureFolder,    ///< where pictures and videos go
  GalleryFolder,    ///< where a gallery goes
  LookForFaces,     ///< a folder with faces, or one that is a face
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
  std::string name;      ///< what a new file would be called
  std::string problem;   ///< why the folder cannot be shown, or the file not be taken
  std::string replaces;  ///< a file that is there already: it is asked about
  friend bool operator==(const BrowserView&, const BrowserView&) = default;
};

/// The file of a face, which stands for its folder.
[[nodiscard]] bool is_face_file(const std::filesystem::path& file);

[[nodiscard]] bool is_saving(Purpose purpose);
/// It is asked for a folder.
[[nodiscard]] bool is_folder(Purpose purpose);

/// A file dialog without its widgets: walks through folders and says which file was meant.
class FileBrowser {
 public:
  /// Shows `folder`, or the nearest one above it that is there.
  void open(Purpose purpose, const std::filesystem::path& folder, std::string name = {});
  void close() { view_ = {}; }
  /// Goes to a folder; a relative one is meant from the one shown. Stays, and says why, when it
  /// cannot be read.
  void enter(const std::filesystem::path& folder);
  /// The file that is meant, when there is nothing to be asked; entering a folder is not. Who is
  /// asked for a folder means the one shown by "." and that of a file by its name. A new
  /// file that would replace one is asked about first: choosing it again is the answer.
  [[nodiscard]] bool choose(const std::filesystem::path& file, std::filesystem::path& chosen);
  /// The chosen file could not be used: the dialog stays and says so.
  void refuse(std::string problem);
  [[nodiscard]] const BrowserView& view() const { return view_; }

 private:
  BrowserView view_;
};

}  // namespace aucast::gui
