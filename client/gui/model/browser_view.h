#pragma once

#include <cstdint>
#include <string>
#include <string_view>
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
  AuthoritiesFile,  ///< the authorities that may vouch for a server
  TokenFile,        ///< the secret that a server asks for
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
  std::string problem;   ///< why the folder cannot be shown or the file cannot be used; empty: no
                         ///< problem
  std::string replaces;  ///< an existing file: the user is asked whether to replace it; empty:
                         ///< nothing is asked
  friend bool operator==(const BrowserView&, const BrowserView&) = default;
};

/// Files for the next connection that were chosen in the dialog; empty: none was chosen since the
/// dialog was last opened.
struct CredentialFiles {
  std::string authorities;
  std::string token;
  friend bool operator==(const CredentialFiles&, const CredentialFiles&) = default;
};

/// Whether a folder is wanted rather than a file.
[[nodiscard]] constexpr bool is_folder(Purpose purpose) {
  return purpose == Purpose::LookForFaces || purpose == Purpose::PictureFolder ||
         purpose == Purpose::GalleryFolder;
}

/// Whether a new file is wanted.
[[nodiscard]] constexpr bool is_saving(Purpose purpose) {
  const bool opening = purpose == Purpose::PlayStream || purpose == Purpose::ComposeStream ||
                       purpose == Purpose::ImportAus || purpose == Purpose::CameraFilm ||
                       purpose == Purpose::AuthoritiesFile || purpose == Purpose::TokenFile;
  return !opening && !is_folder(purpose);
}

/// The ending of a new file; empty: no new file is wanted.
[[nodiscard]] constexpr std::string_view ending_of(Purpose purpose) {
  switch (purpose) {
    case Purpose::SaveStream:
    case Purpose::ExportKeyframes:
      return ".txt";
    case Purpose::ExportTable:
    case Purpose::LogOnsets:
      return ".csv";
    case Purpose::ExportMesh:
      return ".obj";
    case Purpose::ExportGlb:
      return ".glb";
    case Purpose::ExportAu:
      return ".toml";
    default:
      return {};
  }
}

}  // namespace aucast::gui
