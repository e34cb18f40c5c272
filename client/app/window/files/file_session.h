#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/model/table_settings.h"
#include "client/gui/storage/file_browser.h"
#include "client/gui/storage/kept_settings.h"
#include "common/result.h"

namespace aucast::app {

/// The file dialog, which begins in the folder in which the user was last, and what it remembers:
/// streams that were opened, how tables are read, files for the next connection. Opens no file.
/// Thread: the player's.
class FileSession {
 public:
  /// Uses the file that was chosen; returns a sentence for the user, which may be empty.
  using Use =
      std::function<Result<std::string>(gui::Purpose purpose, const std::filesystem::path& file)>;

  /// `streams`: the folder in which stream files are looked for at first.
  explicit FileSession(const std::filesystem::path& streams);

  /// Begins with what the window remembered. A folder that no longer exists is ignored.
  void begin_with(const gui::KeptSettings& kept);
  /// Adds what the window should remember.
  void keep(gui::KeptSettings& kept) const;
  /// Call it when this stream was opened.
  void opened(const std::filesystem::path& file);
  /// Streams that were opened, the newest first.
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }
  /// A stream file that came with the player; empty: none did.
  [[nodiscard]] const std::string& sample() const { return sample_; }

  /// Opens the dialog. `name`: suggested for a new file; `folder`: where it begins, if that is not
  /// where the user was last.
  void browse(gui::Purpose purpose, std::string name,
              const std::optional<std::filesystem::path>& folder = {});
  void enter(const std::filesystem::path& folder) { browser_.enter(folder); }
  /// The user has chosen or typed `name`, in which a leading ~ is the home folder. Calls `use` for
  /// that file and returns the sentence from `use`, unless the user must be asked something first.
  /// If `use` fails, the dialog stays open and says why.
  [[nodiscard]] std::string choose(const std::string& name, const Use& use);
  /// Says in the dialog why a file cannot be used. Returns false if the dialog is not open.
  [[nodiscard]] bool refuse(std::string problem);
  /// Closes the dialog. The next one begins in the folder that this one has shown.
  void close();
  [[nodiscard]] const gui::BrowserView& view() const { return browser_.view(); }
  [[nodiscard]] const gui::CredentialFiles& credentials() const { return credentials_; }

  /// The user has changed how the table that is about to be opened is read: the dialog no longer
  /// says why it cannot be.
  void change_table(const gui::TableSettings& settings);
  /// How this file is to be read if it is a table: as the user has said in the open dialog, else as
  /// it was read last.
  [[nodiscard]] gui::KnownTable table_of(const std::filesystem::path& file);
  /// Call it when this table was read.
  void remember(const gui::KnownTable& table) { gui::remember_table(tables_, table); }
  [[nodiscard]] const gui::TablesView& tables() const { return tables_; }

 private:
  [[nodiscard]] std::filesystem::path& folder_for(gui::Purpose purpose);

  gui::FileBrowser browser_;
  std::filesystem::path own_folder_ = ".";  ///< of the last dialog about the user's own files
  std::filesystem::path saved_in_;
  std::filesystem::path last_folder_;               ///< where a stream was opened last
  std::filesystem::path credentials_folder_ = ".";  ///< where a token or authorities were chosen
  std::vector<std::string> recent_;
  std::string sample_;
  gui::TablesView tables_;
  gui::CredentialFiles credentials_;
};

/// The folder of a file; "." if its path has none.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace aucast::app
