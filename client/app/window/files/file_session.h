#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "client/gui/storage/file_browser.h"
#include "common/result.h"

namespace aucast::app {

/// The file dialog. It begins in the folder in which the user was last. Thread: the player's.
class FileSession {
 public:
  /// Uses the file that was chosen; returns a sentence for the user, which may be empty.
  using Use =
      std::function<Result<std::string>(gui::Purpose purpose, const std::filesystem::path& file)>;

  /// `streams`: the folder in which stream files are looked for at first.
  explicit FileSession(std::filesystem::path streams) : last_folder_(std::move(streams)) {}

  void set_recent(std::vector<std::string> files) { recent_ = std::move(files); }
  /// Streams that were opened, the newest first.
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }
  /// Call it at the start with the folder in which a file was saved before; empty: none was. A
  /// folder that no longer exists is ignored.
  void set_own_folder(const std::filesystem::path& folder);
  /// The folder in which a file was saved or exported last; empty: none was.
  [[nodiscard]] const std::filesystem::path& own_folder() const { return saved_in_; }
  /// Call it when this stream was opened.
  void opened(const std::filesystem::path& file);

  /// Opens the dialog. `name`: suggested for a new file.
  void browse(gui::Purpose purpose, std::string name);
  void look_for_faces(const std::filesystem::path& folder) {
    browser_.open(gui::Purpose::LookForFaces, folder);
  }
  void enter(const std::filesystem::path& folder) { browser_.enter(folder); }
  /// The user has chosen or typed `name`, in which a leading ~ is the home folder. Calls `use` for
  /// that file and returns the sentence from `use`, unless the user must be asked something first.
  /// If `use` fails, the dialog stays open and says why.
  [[nodiscard]] std::string choose(const std::string& name, const Use& use);
  /// Says in the dialog why a file cannot be used. Returns false if the dialog is not open.
  [[nodiscard]] bool refuse(std::string problem);
  /// Stops saying why a file cannot be used. Call it when the user has changed how a file is used.
  void forget_problem() { browser_.forget_problem(); }
  /// Closes the dialog. The next one begins in the folder that this one has shown.
  void close();
  [[nodiscard]] const gui::BrowserView& view() const { return browser_.view(); }

 private:
  [[nodiscard]] std::filesystem::path& folder_for(gui::Purpose purpose);

  gui::FileBrowser browser_;
  std::filesystem::path own_folder_ = ".";  ///< of the last dialog about the user's own files
  std::filesystem::path saved_in_;
  std::filesystem::path last_folder_;               ///< where a stream was opened last
  std::filesystem::path credentials_folder_ = ".";  ///< where a token or authorities were chosen
  std::vector<std::string> recent_;
};

/// The folder of a file; "." if its path has none.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace aucast::app
