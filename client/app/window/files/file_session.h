#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "client/gui/file_browser.h"
#include "common/result.h"

namespace aucast::app {

/// The file dialog, which begins where the user was last. Thread: the player's.
class FileSession {
 public:
  /// Takes the file that was chosen; returns a sentence for the user, or nothing.
  using Use =
      std::function<Result<std::string>(gui::Purpose purpose, const std::filesystem::path& file)>;

  /// `streams`: where stream files are looked for at first.
  explicit FileSession(std::filesystem::path streams) : last_folder_(std::move(streams)) {}

  void set_recent(std::vector<std::string> files) { recent_ = std::move(files); }
  /// Streams that were opened, the latest first.
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }
  /// This stream was opened.
  void opened(const std::filesystem::path& file);

  /// `name`: of a new file, at first.
  void browse(gui::Purpose purpose, std::string name);
  void look_for_faces(const std::filesystem::path& folder) {
    browser_.open(gui::Purpose::LookForFaces, folder);
  }
  void enter(const std::filesystem::path& folder) { browser_.enter(folder); }
  /// Has `use` take what is meant by `name`, unless something is to be asked first: what `use`
  /// said. What it fails with is said in the dialog, which stays.
  [[nodiscard]] std::string choose(const std::string& name, const Use& use);
  /// Says in the dialog why a file cannot be used; false when it is not open.
  [[nodiscard]] bool refuse(std::string problem);
  /// The next dialog begins in the folder that this one has shown.
  void close();
  [[nodiscard]] const gui::BrowserView& view() const { return browser_.view(); }

 private:
  [[nodiscard]] std::filesystem::path& folder_for(gui::Purpose purpose);

  gui::FileBrowser browser_;
  std::filesystem::path own_folder_ = ".";  ///< where the user saved last
  std::filesystem::path last_folder_;       ///< where a stream was opened last
  std::vector<std::string> recent_;
};

/// "." of a file without one.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace aucast::app
